// Oil film between roller and race, in series with the elastic contact:
//   p = delta(Q) - h(Q, u),   1/K = 1/K_r + k,   k = -dh/dQ
//   h = 2.65 alpha^0.54 (eta0 u)^0.70 R^0.43 E'^-0.03 (Q/l)^-0.13
// h Dowson and Higginson, minimum film of an elastic line contact; k = Q/(0.13 h) turned over. It
// is fitted to heavy contacts, and too thin by any factor for light ones (Q below some 30 N of an
// NU 205 in 20 mPa s). p geometric penetration [m], Q normal force [N], delta elastic depth [m], u
// mean entrainment speed [m/s], l contact length [m], R effective radius [m], E' effective modulus
// [Pa], eta0 viscosity at ambient pressure [Pa s], alpha pressure-viscosity coefficient [1/Pa].
// Below `minimum_force` h goes on along its tangent to a finite film at Q = 0, and the film carries
// load at p > -h(0, u). Below 1 cm/s of entrainment h falls as the square of the speed instead:
// with it the force is smooth in all that it depends on. Isothermal, fully flooded, steady: no
// squeeze. Sources: Dowson and Higginson, Elasto-hydrodynamic Lubrication (1966); Xin et al. 2024
// (doi 10.3390/app14209433) eqs. for K_o, whose text lost minus signs and l.
#pragma once

#include <vector>

#include "src/contact_laws/normal_force.hpp"

namespace cagetol {

inline constexpr double kFilmForceExponent = 0.13;
inline constexpr double kFilmSpeedExponent = 0.7;
inline constexpr double kSlowEntrainment = 0.01;  ///< [m/s]
inline constexpr double kNoFilm = 1e30;           ///< stands for a film where nothing touches [m]

/// delta/d of delta - d (delta/d)^-m = p against p/d: every depth behind h is this one function.
/// Tabulated as log2 with its slope.
struct FilmStart {
  static constexpr double kFrom = -4, kTo = 8, kPerUnit = 32;
  std::vector<double> value, slope;
};

struct FilmLaw {
  bool on = false;
  double elastic = 0;        ///< h at 1 N and 1 m/s [m]
  double minimum_force = 0;  ///< [N]
  double minimum_root = 0;   ///< minimum_force^-0.13
  double minimum_depth = 0;  ///< delta at minimum_force [um]
  double decay = 0;          ///< m = 0.13 e: h goes as delta^-m
  double depth_scale = 0;    ///< d at h = 1 m of 1 N [um]
  double softness = 0;       ///< h at delta of 1 um, were it 1 m at 1 N [um]
  FilmStart start;
};

/// Law of one of `slices` equal slices of a contact of `length` [m] and effective `radius` [m];
/// `normal` is that of the slice.
FilmLaw make_film_law(const OilFilm& film, double modulus, double radius, double length,
                      long slices, const NormalLaw& normal);

/// A law at one entrainment speed. `_by_speed`: derivative by u, `_growth`: of the logarithm.
template <class T>
struct FilmAtSpeed {
  T elastic;                      ///< h at 1 N [m]
  T elastic_growth;               ///< [s/m]
  T minimum, minimum_compliance;  ///< h [m] and k [m/N] at minimum_force
  T minimum_by_speed, minimum_compliance_by_speed;
  T depth;        ///< d [um]
  T light_below;  ///< p at minimum_force [um]
};

template <class T>
struct FilmSlopes {
  T compliance, bend;               ///< k [m/N], dk/dQ
  T by_speed, compliance_by_speed;  /// dh/du, dk/du at constant Q
};

/// Of h at Q >= minimum_force.
template <class T>
FilmSlopes<T> film_slopes_above(const FilmAtSpeed<T>& at, T Q, T h) {
  const T inverse = 1.0 / Q, straight = h * inverse;
  FilmSlopes<T> s;
  s.compliance = kFilmForceExponent * straight;
  s.bend = -(1 + kFilmForceExponent) * s.compliance * inverse;
  s.by_speed = h * at.elastic_growth;
  s.compliance_by_speed = s.compliance * at.elastic_growth;
  return s;
}

/// h at Q >= minimum_force [m].
template <class T>
T film_thickness_above(const FilmAtSpeed<T>& at, T Q) {
  return at.elastic * power(Q, -kFilmForceExponent);
}

/// `speed` >= 0 is u.
template <class T>
FilmAtSpeed<T> film_at_speed(const FilmLaw& law, T speed) {
  FilmAtSpeed<T> at;
  // Below 1 cm/s u^n goes on as z^2 (a - b z^2), z = u/(1 cm/s), with the same value and slope.
  const auto slow = speed < kSlowEntrainment;
  const T fast = max(speed, T{} + kSlowEntrainment), z = speed * (1 / kSlowEntrainment);
  constexpr double n = kFilmSpeedExponent, b = 1 - n / 2, a = 1 + b;
  const double limit = __builtin_pow(kSlowEntrainment, n);
  const T factor = select(slow, limit * z * z * (a - b * z * z), power(fast, n));
  // d ln = (2 a - 4 b z^2)/(z (a - b z^2)); nearer to rest h itself is nothing.
  at.elastic_growth = select(
      slow, (2 * a - 4 * b * z * z) / (max(z, T{} + 1e-3) * (a - b * z * z) * kSlowEntrainment),
      n / fast);
  at.elastic = law.elastic * factor;
  at.depth = law.depth_scale * power(max(at.elastic, T{} + 1e-18), 1 / (1 + law.decay));
  at.minimum = at.elastic * law.minimum_root;
  at.light_below = law.minimum_depth - 1e6 * at.minimum;
  const auto slopes = film_slopes_above(at, T{} + law.minimum_force, at.minimum);
  at.minimum_compliance = slopes.compliance;
  at.minimum_by_speed = slopes.by_speed;
  at.minimum_compliance_by_speed = slopes.compliance_by_speed;
  return at;
}

/// h [m].
template <class T>
T film_thickness(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q) {
  const T minimum = T{} + law.minimum_force;
  return select(Q < minimum, at.minimum + at.minimum_compliance * (minimum - Q),
                film_thickness_above(at, max(Q, minimum)));
}

template <class T>
FilmSlopes<T> film_slopes(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q, T h) {
  const T minimum = T{} + law.minimum_force;
  const auto light = Q < minimum;
  FilmSlopes<T> s = film_slopes_above(at, max(Q, minimum), h);
  s.compliance = select(light, at.minimum_compliance, s.compliance);
  s.bend = select(light, T{}, s.bend);
  s.by_speed = select(light, at.minimum_by_speed + at.minimum_compliance_by_speed * (minimum - Q),
                      s.by_speed);
  s.compliance_by_speed = select(light, at.minimum_compliance_by_speed, s.compliance_by_speed);
  return s;
}

/// Thickest film at this speed, at Q = 0 [m].
template <class T>
T thickest_film(const FilmLaw& law, const FilmAtSpeed<T>& at) {
  return at.minimum + at.minimum_compliance * law.minimum_force;
}

/// Integral of Q k dQ above minimum_force, but for a constant [J].
template <class T>
T film_energy_above(T Q, T h) {
  constexpr double share = kFilmForceExponent / (1 - kFilmForceExponent);
  return share * h * Q;
}

}  // namespace cagetol
