// Press fit of a ring on a shaft, or in a housing, in operation: what the ring's diameters change
// by, cause by cause.
//
// Both bodies are thick rings (thick_ring.hpp) that meet at the radius R of the seat. Each grows
// freely by heat, g r with g = alpha (T - T_ref), and by its rotation. What their free growth
// leaves of the interference is taken up by the contact pressure:
//
//   s = s_0/2 + R (g_in - g_out) + u_in(R) - u_out(R)
//   p = max(0, s / (c_in + c_out))
//
// s_0 interference of the cold parts at rest (diametral), c_in, c_out growth of the bodies at R per
// unit of pressure. For one material and a shaft d bored to d_1 the raceway F of the ring grows by
//
//   s_0 (d/F) (1 - (d_1/d)^2) / (1 - (d_1/F)^2)
//
// (Harris and Kotzalas, Essential Concepts of Bearing Technology, 5th ed., chapter 3). The bodies
// stay elastic, seats smooth and round, and each body has one temperature; where the fit is open
// the ring stays centred.
//
// Causes are added in the order fit, heat, spin, each with those before it, because an open fit is
// not linear. Their sum is exact.
#pragma once

#include "src/operation/thick_ring.hpp"

namespace cagetol {

/// Changes of a diameter or clearance by cause [m].
struct Growth {
  double fit = 0, heat = 0, spin = 0;
  double total() const { return fit + heat + spin; }
};

/// One of the two bodies of a fit.
struct FitBody {
  ThickRing ring;
  double heat = 0;   ///< g, free thermal strain
  double speed = 0;  ///< [rad/s]
};

struct PressFit {
  FitBody inside, outside;
  double interference = 0;  ///< s_0 of diameters, cold and at rest; < 0: clearance, NaN: no fit [m]
  double radius = 0;        ///< R of the seat [m]
};

/// In operation.
struct FitState {
  double interference = 0;  ///< 2 s, < 0: the fit is open, NaN: there is none [m]
  double pressure = 0;      ///< p [Pa]
};
FitState fit_state(const PressFit& fit);

/// Change of the diameter 2 r of the outer body (`outside`) or of the inner one.
Growth fit_growth(const PressFit& fit, bool outside, double radius);

}  // namespace cagetol
