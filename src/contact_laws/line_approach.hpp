// Elastic approach of a roller's axis and a ring by the two-dimensional theory of line contact, and
// the stiffness that the races get from it (contact.race.approach = "line").
//
//   roller  d1 = q (1 - nu1^2)/(pi E1) (2 ln(4 R/a) - 1)             surface against its axis
//   ring    d2 = q (1 - nu2^2)/(pi E2) (2 ln(2 t/a) - nu2/(1 - nu2))  surface against the depth t
//   a^2 = 8 q R'/(pi E'),   1/R' = 1/R + 1/R_race                    half width (hertz_line.hpp)
//
// q load per length [N/m], R radius of the roller, R_race of the race, concave negative [m]. A
// half-space has no approach of its own: t has to be chosen. Assumption: t is the ring's thickness
// at the race, as if its seat were rigid. With half of t the two races of the NU 205 give way 6 to
// 8 % less. Valid for a << R, t, and a long contact.
//
// The kernels keep Q = K delta^(10/9) (normal_force.hpp). K, one for both races, is such that the
// roller's two contacts in series give way as above at one load: 5 F/(Z L) of the radial load F,
// Stribeck's estimate of the most loaded roller, or kLeastLineLoad. From 0.1 to 3 times that load
// the power law's approach is within 3 % of the relation's for both races together at 1 kN on the
// NU 205 (0.3 to 10 kN: 5 %), at either race within 5 % (9 %):
// tests/unit/src/line_approach_test.cpp.
//
// Source: K. L. Johnson, Contact Mechanics (1985), section 5.6 (doi 10.1017/CBO9781139171731).
#pragma once

#include <array>

#include "src/scene/scene.hpp"

namespace cagetol {

inline constexpr double kLeastLineLoad = 1e3;  ///< [N/m]

struct LineContact {
  Material roller, ring;
  double radius = 0;     ///< R [m]
  double curvature = 0;  ///< 1/R_race, concave negative [1/m]
  double depth = 0;      ///< t [m]
};

/// a [m].
double half_width(const LineContact& contact, double load);

/// d1, d2 [m]. `load`: q.
double roller_approach(const LineContact& contact, double load);
double ring_approach(const LineContact& contact, double load);

/// A roller of mean diameter on the inner and on the outer race.
std::array<LineContact, 2> race_lines(const Scene& scene);

/// q at which K is taken [N/m].
double reference_line_load(const Scene& scene);

/// E' for make_normal_law() of the races [Pa]: the pair's own ("palmgren"), or the one with which
/// the two races give way as above ("line"). Throws std::domain_error where the contact at that
/// load is wider than a quarter of the roller's radius or of the ring's thickness.
double race_stiffness_modulus(const Scene& scene);

}  // namespace cagetol
