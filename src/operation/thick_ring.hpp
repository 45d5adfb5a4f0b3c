// Radial growth of a cylinder, hollow or solid, whose ends are free (plane stress), under pressure
// on its surfaces and by its own rotation.
//
//   a, b  inner and outer radius [m], a = 0: solid, b infinite: a bore in a large body
//   p, q  pressure on the inner, on the outer surface, > 0 in compression [Pa]
//   w     angular speed [rad/s]
//   u     radial displacement at radius r, > 0 outwards [m]
//
// Lame (Timoshenko and Goodier, Theory of Elasticity, 3rd ed., article 28):
//
//   u = [ (1 - nu) (p a^2 - q b^2) r + (1 + nu) (p - q) a^2 b^2 / r ] / (E (b^2 - a^2))
//
// Rotating disc (the same, article 32):
//
//   u = rho w^2 r/(8 E) [ (3 + nu)(1 - nu)(a^2 + b^2) + (3 + nu)(1 + nu) a^2 b^2/r^2
//                         - (1 - nu^2) r^2 ]
//
// which for a thin ring of radius r becomes rho w^2 r^3/E. Valid for elastic, homogeneous bodies of
// one cross-section along their axis: shoulders and lips of a ring are not seen.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

struct ThickRing {
  double inner_radius = 0, outer_radius = 0;  ///< a, b [m]
  Material material;
};

/// u at radius r > 0 under the pressures p inside and q outside.
double pressed_growth(const ThickRing& ring, double inside, double outside, double radius);

/// u at radius r > 0 of the ring rotating at `speed`. Throws std::domain_error where the ring has
/// no end (b infinite) and turns.
double spinning_growth(const ThickRing& ring, double speed, double radius);

}  // namespace cagetol
