// Elastic approach of a roller's axis and a ring by the two-dimensional theory of line contact.
//
//   roller  d1 = q (1 - nu1^2)/(pi E1) (2 ln(4 R/a) - 1)             surface against its axis
//   ring    d2 = q (1 - nu2^2)/(pi E2) (2 ln(2 t/a) - nu2/(1 - nu2))  surface against the depth t
//   a^2 = 8 q R'/(pi E'),   1/R' = 1/R + 1/R_race                    half width (hertz_line.hpp)
//
// q load per length [N/m], R radius of the roller, R_race of the race, concave negative [m]. A
// half-space has no approach of its own: t has to be chosen. Assumption: t is the ring's thickness
// at the race, as if its seat were rigid. With half of t the two races of the NU 205 deflect 6 to
// 8 % less. Valid for a << R, t, and a long contact.
//
// Source: K. L. Johnson, Contact Mechanics (1985), section 5.6 (doi 10.1017/CBO9781139171731).
#pragma once

#include "src/contact_laws/material.hpp"

namespace cagetol {

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

}  // namespace cagetol
