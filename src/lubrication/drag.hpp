// Drag of oil and air in the free space of a bearing ("churning"):
//
//   rho = fill rho_oil + (1 - fill) rho_air,   eta likewise
//   F   = 1/2 rho C_d D L v^2                     roller across its axis [N]
//   M   = 1/2 rho w^2 (r_o^5 - r_i^5) C_n         one face of a disc or ring [N m]
//         Re  = rho r_o^2 w/eta
//         C_n = 1.935/sqrt(Re) laminar, 0.073 Re^-0.2 turbulent, transition about Re = 3e5
//   tau = 1/2 f rho (w r)^2                       cylinder in a gap c [Pa]
//         Re  = rho w r c/eta
//         f   = 2/Re laminar, 0.0791 Re^-0.25 turbulent, transition about Re = 2000
//
// v speed relative to the fluid [m/s], w likewise [rad/s]; the fluid is carried along with a share
// of the cage's speed. `fill` is an assumption: in the literature a calibration constant. The
// regimes are blended over ln Re, so that coefficients are smooth; at w = 0 moment and shear
// vanish.
//
// Sources: Schlichting, Boundary-Layer Theory, discs (3.87 and 0.146 for both faces); Rumbarger et
// al., J. Lubr. Technol. 95 (1973) 401.
#pragma once

#include <cmath>
#include <numbers>

#include "src/contact_laws/step.hpp"
#include "src/numerics/dual.hpp"

namespace cagetol {

/// Fluid of the bearing's free space.
struct FreeSpaceFluid {
  double density = 0;    ///< [kg/m3]
  double viscosity = 0;  ///< [Pa s]
};
/// `fill`: share of the free space that is oil, in [0, 1].
FreeSpaceFluid free_space_fluid(double fill, double oil_density, double oil_viscosity);

namespace drag_detail {
template <class T>
T blended(T re, double transition, T laminar, T turbulent) {
  constexpr double kSpan = 0.7;  // half width of the blending in ln Re
  const T over = std::numbers::ln2 * log2(re * (1 / transition));
  return laminar + smooth_step((over + kSpan) * (0.5 / kSpan)) * (turbulent - laminar);
}
}  // namespace drag_detail

/// Coefficient of one face of a disc and of a cylinder in a gap, at Reynolds number `re` > 0.
template <class T>
T disc_coefficient(T re) {
  return drag_detail::blended(re, 3e5, 1.935 / sqrt(re), 0.073 * power(re, -0.2));
}
template <class T>
T gap_coefficient(T re) {
  return drag_detail::blended(re, 2000, 2.0 / re, 0.0791 * power(re, -0.25));
}

/// Moment of one face against its turning at `w` relative to the fluid [N m], r_i < r_o [m].
template <class T>
T disc_moment(const FreeSpaceFluid& fluid, T w, double outer, double inner) {
  if (value_of(w) == 0) return T{};
  const T speed = value_of(w) < 0 ? -1.0 * w : w;
  const double fifth = std::pow(outer, 5) - std::pow(inner, 5);
  return 0.5 * fluid.density * fifth * w * speed *
         disc_coefficient(speed * (fluid.density * outer * outer / fluid.viscosity));
}

/// Moment on a cylinder of radius r and length l in a gap c, turning at `w` [N m].
template <class T>
T gap_moment(const FreeSpaceFluid& fluid, T w, double radius, double length, double gap) {
  if (value_of(w) == 0) return T{};
  const T speed = value_of(w) < 0 ? -1.0 * w : w;
  const double r2 = radius * radius, area = 2 * std::numbers::pi * radius * length;
  return 0.5 * fluid.density * r2 * radius * area * w * speed *
         gap_coefficient(speed * (fluid.density * radius * gap / fluid.viscosity));
}

}  // namespace cagetol
