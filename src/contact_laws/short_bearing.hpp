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
// Oil fills the gap where h is below the `layer`: with q = 1/layer, 1/h^3 above becomes
// (1/h)(1/h - q)^2 and Couette's 1/h becomes 1/h - q, both none beyond, so that nothing jumps where
// the gap reaches the layer. An assumption: no source says how a land starves.
// Integrals by Gauss' points in Sommerfeld's gamma, 1 - eps cos(theta) = (1 - eps^2)/(1 + eps
// cos(gamma)), in which flooded ones are polynomials of its cosine and sine. Valid for L well below
// 2 R, laminar, isothermal, lands parallel to their ring. Roughness ends it: from two `least`
// heights of gap on h shrinks ever more slowly, and never below `least`; there the dry contact
// carries.
// Sources: Ocvirk, Short-bearing approximation for full journal bearings, NACA TN 2808 (1952);
// squeeze and spins in one velocity: Booker, J. Basic Eng. 87 (1965) 537 (doi 10.1115/1.3650602).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/numerics/pack.hpp"

namespace cagetol {

struct ShortBearing {
  bool on = false;
  double pressure = 0;                                     ///< eta R L^3 [N s m^2]
  double torque = 0;                                       ///< 2 pi eta R^3 L [N m s m]
  double axial = 0;                                        ///< 2 pi eta R L [N s]
  double clearance = 0;                                    ///< c [m]
  double minimum = 0;                                      ///< [m]
  double layer = std::numeric_limits<double>::infinity();  ///< gap up to which oil fills it [m]
};

struct ShortBearingFilm {
  double force[2];                   ///< F [N]
  double damping[2][2];              ///< -dF/dV [N s/m]
  double stiffness[2][2];            ///< -dF/dD at constant V [N/m]
  double torque, axial;              ///< -M/(w_j - w_h) [N m s], -N/v_x [N s/m]
  double torque_slope, axial_slope;  ///< their derivatives by |D|
  double direction[2];               ///< D/|D|
};

namespace short_bearing_detail {
/// Places and weights of Gauss' rule of 16 points on (-1, 1), half of them: it is symmetric.
inline constexpr double kPlace[8] = {0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
                                     0.6178762444026438, 0.7554044083550030, 0.8656312023878318,
                                     0.9445750230732326, 0.9894009349916499};
inline constexpr double kWeight[8] = {0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
                                      0.1495959888165767, 0.1246289712555339, 0.0951585116824928,
                                      0.0622535239386479, 0.0271524594117541};

/// Integrals over theta where oil is pressed, n towards the narrowest gap, t across.
struct Sums {
  double nn = 0, nt = 0, tt = 0;     ///< of e e/h^3
  double dnn = 0, dnt = 0, dtt = 0;  ///< of (V.e) e e times -d(1/h^3)/dh
};

/// Sommerfeld's gamma of an angle; `b` = eps/(1 + sqrt(1 - eps^2)).
inline double gamma_of(double theta, double b) {
  return theta + 2 * std::atan2(b * std::sin(theta), 1 - b * std::cos(theta));
}

/// Adds what lies between two angles; A, B velocity along n and t, `dry` = 1/layer.
inline void add_arc(double from, double to, double eps, double root, double c, double dry, double A,
                    double B, Sums& sums) {
  const double b = eps / (1 + root), first = gamma_of(from, b), last = gamma_of(to, b);
  const double half = 0.5 * (last - first), cm = std::cos(0.5 * (first + last)),
               sm = std::sin(0.5 * (first + last));
  Pack nn{}, nt{}, tt{}, dnn{}, dnt{}, dtt{};
  for (int i = 0; i < 8; i += kLanes) {
    Pack cd, sd;
    sine_cosine(half * load(kPlace + i), sd, cd);
    for (const double side : {1.0, -1.0}) {
      const Pack cosine = cm * cd - side * sm * sd, sine = sm * cd + side * cm * sd;
      const Pack u = 1 + eps * cosine, inverse = 1 / u;
      const Pack n = (cosine + eps) * inverse, t = root * sine * inverse;
      const Pack thin = u * (1 / (c * root * root)), wet = thin - dry;  // 1/h
      const Pack weight = (half * root) * load(kWeight + i) * inverse * wet * thin;
      const Pack whole = weight * wet, slope = weight * thin * (3 * thin - dry) * (A * n + B * t);
      nn += whole * n * n;
      nt += whole * n * t;
      tt += whole * t * t;
      dnn += slope * n * n;
      dnt += slope * n * t;
      dtt += slope * t * t;
    }
  }
  sums.nn += sum(nn);
  sums.nt += sum(nt);
  sums.tt += sum(tt);
  sums.dnn += sum(dnn);
  sums.dnt += sum(dnt);
  sums.dtt += sum(dtt);
}
}  // namespace short_bearing_detail

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
  // Pressure rises over the half circle around the direction of V, as far as oil fills the gap.
  constexpr double pi = std::numbers::pi;
  const bool flooded = !(law.layer < c * (1 + eps));
  const double dry = 1 / law.layer,
               filled = flooded ? pi : std::acos(std::min((1 - law.layer / c) / eps, 1.0));
  const double to_V = std::atan2(B, A);
  short_bearing_detail::Sums sums;
  for (const double turn : {-2 * pi, 0.0, 2 * pi}) {
    if (flooded && turn != 0) continue;
    const double from = to_V + turn - pi / 2, to = to_V + turn + pi / 2;
    const double wet_from = flooded ? from : std::max(from, -filled),
                 wet_to = flooded ? to : std::min(to, filled);
    if (wet_to > wet_from)
      short_bearing_detail::add_arc(wet_from, wet_to, eps, root, c, dry, A, B, sums);
  }
  const double nn = law.pressure * sums.nn, nt = law.pressure * sums.nt,
               tt = law.pressure * sums.tt;
  ShortBearingFilm film;
  const double t[2] = {-n[1], n[0]};
  const double F_n = -(nn * A + nt * B), F_t = -(nt * A + tt * B);
  // d(force)/d(seen displacement), then of that by D.
  const double around = e > 0 ? seen / e : 1;
  const double k_nn = law.pressure * sums.dnn * slope, k_nt = law.pressure * sums.dnt * around;
  const double k_tn = law.pressure * sums.dnt * slope, k_tt = law.pressure * sums.dtt * around;
  for (int i = 0; i < 2; ++i) {
    film.force[i] = F_n * n[i] + F_t * t[i];
    film.direction[i] = n[i];
    for (int j = 0; j < 2; ++j) {
      film.damping[i][j] = nn * n[i] * n[j] + nt * (n[i] * t[j] + t[i] * n[j]) + tt * t[i] * t[j];
      film.stiffness[i][j] =
          k_nn * n[i] * n[j] + k_nt * n[i] * t[j] + k_tn * t[i] * n[j] + k_tt * t[i] * t[j];
    }
  }
  // Couette shear where there is oil, over 2 pi: the integral of 1/h - q and its slope by eps.
  const double turned = short_bearing_detail::gamma_of(filled, eps / (1 + root));
  const double shear = (turned / (c * root) - filled * dry) / pi,
               growth =
                   (std::sin(turned) + eps * turned) / (c * root * root * root) / pi * (slope / c);
  film.torque = law.torque * shear;
  film.axial = law.axial * shear;
  film.torque_slope = law.torque * growth;
  film.axial_slope = law.axial * growth;
  return film;
}

}  // namespace cagetol
