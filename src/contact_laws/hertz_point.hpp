// Hertz's contact of two bodies at a point, by the approximations of Hamrock and Brewe:
//
//   k  = (A/B)^(2/pi),   A >= B the reduced radii R_1, R_2        ratio of the ellipse's axes
//   e  = 1 + q B/A,      f = pi/2 + q ln(A/B),   q = pi/2 - 1     elliptic integrals
//   1/R = 1/R_1 + 1/R_2
//   F  = K delta^1.5,    K = pi k E' sqrt(2 e R/(9 f^3))
//   a  = (6 k^2 e F R/(pi E'))^(1/3),   b = a/k                   half axes
//
// F normal force [N], delta approach [m], R_1 reduced radius along the first direction and R_2
// across it [m], E' as in hertz_line.hpp. The approach is within 3 % of that by elliptic integrals,
// and exact for a sphere on a plane.
// Source: Hamrock and Brewe, J. Lubr. Technol. 105 (1983) 171 (doi 10.1115/1.3254558).
#pragma once

namespace cagetol {

struct HertzPoint {
  double along = 0, across = 0;  ///< R_1, R_2 [m]
  double modulus = 0;            ///< E' [Pa]
  double stiffness = 0;          ///< K [N/m^1.5]
  double area = 0;               ///< pi a b at 1 N [m2/N^(2/3)]
};

/// Throws std::domain_error unless all are positive.
HertzPoint hertz_point(double along, double across, double modulus);

}  // namespace cagetol
