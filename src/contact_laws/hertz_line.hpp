// Hertz's line contact: what a force makes of the contact's strip. Not used by the dynamics; for
// stresses, reports and tests.
//
//   b  = sqrt(8 Q R/(pi l E'))
//   p  = 2 Q/(pi b l)
//   E' = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2]
//   1/R = 1/R1 + 1/R2                           concave radii negative
//
// Q normal force [N], l length of the contact [m], R effective radius of curvature [m], b half
// width [m], p peak pressure [Pa]. Valid for b << R and a contact long against b, elastic, without
// friction. Source: K. L. Johnson, Contact Mechanics (1985), eqs. (4.43), (4.45), there with
// E* = E'/2 and P = Q/l (doi 10.1017/CBO9781139171731).
#pragma once

#include "src/contact_laws/material.hpp"

namespace cagetol {

struct HertzLine {
  double half_width;     ///< b [m]
  double peak_pressure;  ///< p [Pa]
};

/// E' of two materials [Pa].
double effective_modulus(const Material& first, const Material& second);

/// Throws std::domain_error unless force >= 0 and radius, length and modulus are > 0.
HertzLine hertz_line(double force, double radius, double length, double modulus);

}  // namespace cagetol
