// Oil film of a short journal bearing: cage land in (or around) its guiding ring.
//   dp/dx = 0 at mid-width, p = 0 at both edges; d2p/dx2 = -12 eta W/h^3,  W = V.e(theta)
//   h = c - D.e(theta),   V = D' - (w_j + w_h)/2 e_x x D
//   F = -eta R L^3 int (V.e) e/h^3 dtheta over V.e > 0      (Guembel: no suction)
//   M = -2 pi eta R^3 L (w_j - w_h)/(c sqrt(1 - eps^2)), N = M v_x/((w_j - w_h) R^2)  (Couette)
// D the journal's displacement in its housing [m], D' its rate, w_j and w_h their spins [rad/s], V
// the velocity that would squeeze the film as hard without spins, e(theta) the radial direction, c
// radial clearance [m], eps = |D|/c, R radius, L width of the land [m], eta viscosity [Pa s]; F
// force on the journal, -F on the housing, and on both the moment of F that the spins in V are
// conjugate to: film and bodies exchange -F.V exactly. M turns the journal against w_j - w_h, N
// pulls it against its axial sliding v_x. Without squeeze F is Ocvirk's,
//   |F| = eta w_j R L^3/(4 c^2) eps/(1 - eps^2)^2 sqrt(pi^2 (1 - eps^2) + 16 eps^2),
//   attitude angle tan = pi sqrt(1 - eps^2)/(4 eps);   at eps = 0 M is Petroff's.
// Integrals by Sommerfeld's substitution 1 - eps cos(theta) = (1 - eps^2)/(1 + eps cos(gamma)): in
// closed form. Valid for L well below 2 R, laminar, isothermal, fully flooded, lands parallel to
// their ring. Roughness ends it: from two `least` heights of gap on h shrinks ever more slowly, and
// never below `least`; there the dry contact carries.
// Sources: Ocvirk, Short-bearing approximation for full journal bearings, NACA TN 2808 (1952);
// squeeze and spins in one velocity: Booker, J. Basic Eng. 87 (1965) 537 (doi 10.1115/1.3650602).
#pragma once

#include <cmath>
#include <numbers>

namespace cagetol {

struct ShortBearing {
  bool on = false;
  double pressure = 0;   ///< eta R L^3 [N s m^2]
  double torque = 0;     ///< 2 pi eta R^3 L [N m s m]
  double axial = 0;      ///< 2 pi eta R L [N s]
  double clearance = 0;  ///< c [m]
  double minimum = 0;    ///< [m]
};

struct ShortBearingFilm {
  double force[2];                   ///< F [N]
  double damping[2][2];              ///< -dF/dV [N s/m]
  double stiffness[2][2];            ///< -dF/dD at constant V [N/m]
  double torque, axial;              ///< -M/(w_j - w_h) [N m s], -N/v_x [N s/m]
  double torque_slope, axial_slope;  ///< their derivatives by |D|
  double direction[2];               ///< D/|D|
};

/// `D`, `V` in two directions y, z, x the axis they turn about.
inline ShortBearingFilm short_bearing_film(const ShortBearing& law, const double D[2],
                                           const double V[2]) {
  const double e = std::hypot(D[0], D[1]), c = law.clearance;
  const double n[2] = {e > 0 ? D[0] / e : 1, e > 0 ? D[1] / e : 0};
  // Displacement as the film sees it, and its slope.
  const double free = c - 2 * law.minimum;
  double seen = e, slope = 1;
  if (e > free) {
    const double z = (e - free) / law.minimum;
    seen = free + law.minimum * z / (1 + z);
    slope = 1 / ((1 + z) * (1 + z));
  }
  const double eps = seen / c, root = std::sqrt(1 - eps * eps);
  const double A = V[0] * n[0] + V[1] * n[1], B = n[0] * V[1] - n[1] * V[0];
  // From a right angle before V to one behind it, in gamma.
  const double size = std::hypot(A, B), cosine = size > 0 ? A / size : 1,
               sine = size > 0 ? B / size : 0;
  const double g1 = std::atan2(-root * cosine, sine - eps);
  double g2 = std::atan2(root * cosine, -sine - eps);
  if (g2 <= g1) g2 += 2 * std::numbers::pi;
  const double c1 = std::cos(g1), s1 = std::sin(g1), c2 = std::cos(g2), s2 = std::sin(g2);
  const double turn = g2 - g1;
  // Integrals of cos^a sin^b over gamma.
  const double C1 = s2 - s1, S1 = c1 - c2;
  const double C2 = 0.5 * (turn + s2 * c2 - s1 * c1), S2 = turn - C2;
  const double CS = 0.5 * (s2 * s2 - s1 * s1);
  const double C3 = C1 - (s2 * s2 * s2 - s1 * s1 * s1) / 3, CSS = C1 - C3;
  const double CCS = (c1 * c1 * c1 - c2 * c2 * c2) / 3, S3 = S1 - CCS;
  // Of cos^a sin^b/h^3 and /h^4 over theta, in powers of c.
  const double r2 = root * root, r4 = r2 * r2;
  const double cube = law.pressure / (c * c * c), fourth = 3 * cube / c;
  const double nn = cube * (eps * eps * turn + 2 * eps * C1 + C2) / (r4 * root),
               nt = cube * (eps * S1 + CS) / r4, tt = cube * S2 / (r2 * root);
  const double nnn = fourth * (eps * eps * eps * turn + 3 * eps * eps * C1 + 3 * eps * C2 + C3) /
                     (r4 * r2 * root),
               nnt = fourth * (eps * eps * S1 + 2 * eps * CS + CCS) / (r4 * r2),
               ntt = fourth * (eps * S2 + CSS) / (r4 * root), ttt = fourth * S3 / r4;
  ShortBearingFilm film;
  const double t[2] = {-n[1], n[0]};
  const double F_n = -(nn * A + nt * B), F_t = -(nt * A + tt * B);
  // d(force)/d(seen displacement), then of that by D.
  const double around = e > 0 ? seen / e : 1;
  const double k_nn = (nnn * A + nnt * B) * slope, k_nt = (nnt * A + ntt * B) * around;
  const double k_tn = (nnt * A + ntt * B) * slope, k_tt = (ntt * A + ttt * B) * around;
  for (int i = 0; i < 2; ++i) {
    film.force[i] = F_n * n[i] + F_t * t[i];
    film.direction[i] = n[i];
    for (int j = 0; j < 2; ++j) {
      film.damping[i][j] = nn * n[i] * n[j] + nt * (n[i] * t[j] + t[i] * n[j]) + tt * t[i] * t[j];
      film.stiffness[i][j] =
          k_nn * n[i] * n[j] + k_nt * n[i] * t[j] + k_tn * t[i] * n[j] + k_tt * t[i] * t[j];
    }
  }
  const double shear = 1 / (c * root), growth = eps / (c * r2) * slope;
  film.torque = law.torque * shear;
  film.axial = law.axial * shear;
  film.torque_slope = film.torque * growth;
  film.axial_slope = film.axial * growth;
  return film;
}

}  // namespace cagetol
