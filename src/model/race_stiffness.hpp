// Stiffness of the roller-race contacts: by Palmgren's formula, or by the two-dimensional theory of
// line contact (line_approach.hpp, contact.race.approach = "line").
//
// The kernels keep Q = K delta^(10/9) (normal_force.hpp). K, one for both races, is such that the
// roller's two contacts in series deflect as above at one load: 5 F/(Z L) of the radial load F,
// Stribeck's estimate of the most loaded roller, or kSmallestLineLoad. From 0.1 to 3 times that
// load the power law's approach is within 3 % of the relation's for both races together at 1 kN on
// the NU 205 (0.3 to 10 kN: 5 %), at either race within 5 % (9 %):
// tests/unit/src/line_approach_test.cpp.
#pragma once

#include <array>

#include "src/contact_laws/line_approach.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

inline constexpr double kSmallestLineLoad = 1e3;  ///< [N/m]

/// A roller of mean diameter on the inner and on the outer race.
std::array<LineContact, 2> race_lines(const Scene& scene);

/// Line load at which K is taken [N/m].
double reference_line_load(const Scene& scene);

/// E' for make_normal_law() of the races [Pa]: the pair's own ("palmgren"), or the one with which
/// the two races deflect as above ("line"). Throws std::domain_error where the contact at that
/// load is wider than a quarter of the roller's radius or of the ring's thickness.
double race_stiffness_modulus(const Scene& scene);

}  // namespace cagetol
