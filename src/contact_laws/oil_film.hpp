// Oil film between roller and race, in series with the elastic contact:
//   p = delta(Q) - h(Q, u),   1/K = 1/K_r + k,   k = -dh/dQ
//   series:          h = h_E = 2.65 alpha^0.54 (eta0 u)^0.70 R^0.43 E'^-0.03 (Q/l)^-0.13
//   series-bounded:  h = max(h_E, h_R), h_R = 4.9 eta0 u R l/Q
// h_E Dowson and Higginson, minimum film of an elastic line contact; k = Q/(0.13 h) turned over.
// h_R Martin, rigid cylinders and an oil whose viscosity no pressure raises: elasticity and
// pressure only ever thicken a film of given load, so that it bounds h from below. It rules light
// contacts (Q below some 30 N of an NU 205 in 20 mPa s), where h_E, fitted to heavy ones, is too
// thin by any factor. Between a third less and half more force than at the corner where both agree,
// ln h is a parabola of ln Q that meets both with their slopes, at most 9 % above the greater.
// p geometric penetration [m], Q normal force [N], delta elastic depth [m], u mean entrainment
// speed [m/s], l contact length [m], R effective radius [m], E' effective modulus [Pa], eta0
// viscosity at ambient pressure [Pa s], alpha pressure-viscosity coefficient [1/Pa]. Below
// `least_force` h goes on along its tangent to a finite film at Q = 0, and the film carries load at
// p > -h(0, u). Below 1 cm/s of entrainment h falls as the square of the speed instead: with it the
// force is smooth in all that it depends on. Isothermal, fully flooded, steady: no squeeze.
// Sources: Dowson and Higginson, Elasto-hydrodynamic Lubrication (1966); Martin, Lubrication of
// gear teeth, Engineering 102 (1916) 119; the chart of regimes: Hamrock, Schmid and Jacobson,
// Fundamentals of Fluid Film Lubrication (2004) ch. 18; Xin et al. 2024 (doi 10.3390/app14209433)
// eqs. for K_o, whose text lost minus signs and l.
#pragma once

#include <vector>

#include "src/contact_laws/normal_force.hpp"

namespace cagetol {

inline constexpr double kFilmForceExponent = 0.13;
inline constexpr double kFilmSpeedExponent = 0.7;
inline constexpr double kMartin = 4.9;            ///< h_R Q/(eta0 u R l)
inline constexpr double kSlowEntrainment = 0.01;  ///< [m/s]
inline constexpr double kCorner =
    0.40546510810816438;  ///< ln 1.5: half width of the corner in ln Q
inline constexpr double kCornerEnd = 0.94865464234201;  ///< 1.5^-0.13
inline constexpr double kNoFilm = 1e30;  ///< stands for a film where nothing touches [m]

/// delta/d of delta - d (delta/d)^-m = p against p/d: every depth behind h_E is this one function.
/// Tabulated as log2 with its slope.
struct FilmStart {
  static constexpr double kFrom = -4, kTo = 8, kPerUnit = 32;
  std::vector<double> value, slope;
};

struct FilmLaw {
  bool on = false, bounded = false;
  double elastic = 0;      ///< h_E at 1 N and 1 m/s [m]
  double isoviscous = 0;   ///< h_R likewise
  double least_force = 0;  ///< [N]
  double least_root = 0;   ///< least_force^-0.13
  double least_depth = 0;  ///< delta at least_force [um]
  double decay = 0;        ///< m = 0.13 e: h_E goes as delta^-m
  double depth_scale = 0;  ///< d at h_E = 1 m of 1 N [um]
  double depth_of_newton = 0,
         depth_exponent = 0;  ///< delta = depth_of_newton Q^depth_exponent [um]
  double softness = 0;        ///< h_E at delta of 1 um, were it 1 m at 1 N [um]
  double corner_lower = 0;    ///< depth at the lower end of the corner over that at its upper end
  FilmStart start;
};

/// Law of one of `slices` equal slices of a contact of `length` [m] and effective `radius` [m];
/// `normal` is that of the slice.
FilmLaw make_film_law(const OilFilm& film, double modulus, double radius, double length,
                      long slices, const NormalLaw& normal);

/// A law at one entrainment speed. `_by_speed`: derivative by u, `_growth`: of the logarithm.
template <class T>
struct FilmAtSpeed {
  T elastic, isoviscous;                ///< h_E and h_R at 1 N [m]
  T elastic_growth, isoviscous_growth;  ///< [s/m]
  T corner;                             ///< force where they agree [N]
  T corner_height, corner_growth;       ///< h_E there [m]; growth of the force [s/m]
  T least, least_compliance;            ///< h [m] and k [m/N] at least_force
  T least_by_speed, least_compliance_by_speed;
  T depth;                                    ///< d [um]
  T light_below, rigid_below, elastic_above;  ///< p [um] where another part of h begins
};

template <class T>
struct FilmSlopes {
  T compliance, bend;               ///< k [m/N], dk/dQ
  T by_speed, compliance_by_speed;  /// dh/du, dk/du at constant Q
};

// The corner: ln(h/h_agree) = turn (l^2 + corner^2) - middle l with l = ln(Q/Q_agree).
inline constexpr double kCornerMiddle = (1 + kFilmForceExponent) / 2,
                        kCornerTurn = (1 - kFilmForceExponent) / (4 * kCorner);
inline constexpr double kLn2 = 0.69314718055994531;
template <class T>
T corner_shape(T l) {
  return exp2((kCornerTurn * (l * l + kCorner * kCorner) - kCornerMiddle * l) * (1 / kLn2));
}

/// Of h at Q >= least_force.
template <class T>
FilmSlopes<T> film_slopes_above(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q, T h) {
  const T inverse = 1.0 / Q, straight = h * inverse;
  FilmSlopes<T> s;
  s.compliance = kFilmForceExponent * straight;
  s.bend = -(1 + kFilmForceExponent) * s.compliance * inverse;
  s.by_speed = h * at.elastic_growth;
  s.compliance_by_speed = s.compliance * at.elastic_growth;
  if (!law.bounded) return s;
  const auto rigid = 1.5 * Q < at.corner, corner = (1.5 * Q >= at.corner) & (Q < 1.5 * at.corner);
  s.compliance = select(rigid, straight, s.compliance);
  s.bend = select(rigid, -2.0 * straight * inverse, s.bend);
  s.by_speed = select(rigid, h * at.isoviscous_growth, s.by_speed);
  s.compliance_by_speed = select(rigid, straight * at.isoviscous_growth, s.compliance_by_speed);
  if (any(corner)) {
    const T l = kLn2 * log2(select(corner, Q / at.corner, T{} + 1.0));
    const T steep = kCornerMiddle - 2 * kCornerTurn * l;  // -dln h/dln Q
    const T growth = at.elastic_growth + (steep - kFilmForceExponent) * at.corner_growth;
    const T k = steep * straight, turning = 2 * kCornerTurn * straight;
    s.compliance = select(corner, k, s.compliance);
    s.bend = select(corner, -((1.0 + steep) * k + turning) * inverse, s.bend);
    s.by_speed = select(corner, h * growth, s.by_speed);
    s.compliance_by_speed =
        select(corner, k * growth + turning * at.corner_growth, s.compliance_by_speed);
  }
  return s;
}

/// h at Q >= least_force [m].
template <class T>
T film_thickness_above(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q) {
  T h = at.elastic * power(Q, -kFilmForceExponent);
  if (!law.bounded) return h;
  h = select(1.5 * Q < at.corner, at.isoviscous / Q, h);
  const auto corner = (1.5 * Q >= at.corner) & (Q < 1.5 * at.corner);
  if (any(corner)) {
    const T l = kLn2 * log2(select(corner, Q / at.corner, T{} + 1.0));
    h = select(corner, at.corner_height * corner_shape(l), h);
  }
  return h;
}

/// `speed` >= 0 is u.
template <class T>
FilmAtSpeed<T> film_at_speed(const FilmLaw& law, T speed) {
  FilmAtSpeed<T> at;
  // Below 1 cm/s u^n goes on as z^2 (a - b z^2), z = u/(1 cm/s), with the same value and slope.
  const auto slow = speed < kSlowEntrainment;
  const T fast = max(speed, T{} + kSlowEntrainment), z = speed * (1 / kSlowEntrainment);
  const auto speed_power = [&](double n, T of_fast, T& value, T& growth) {
    const double b = 1 - n / 2, a = 1 + b;
    const double limit =
        n == 1 ? kSlowEntrainment : __builtin_pow(kSlowEntrainment, kFilmSpeedExponent);
    value = select(slow, limit * z * z * (a - b * z * z), of_fast);
    // d ln = (2 a - 4 b z^2)/(z (a - b z^2)); nearer to rest h itself is nothing.
    growth = select(
        slow, (2 * a - 4 * b * z * z) / (max(z, T{} + 1e-3) * (a - b * z * z) * kSlowEntrainment),
        n / fast);
  };
  T factor;
  speed_power(kFilmSpeedExponent, power(fast, kFilmSpeedExponent), factor, at.elastic_growth);
  at.elastic = law.elastic * factor;
  at.depth = law.depth_scale * power(max(at.elastic, T{} + 1e-18), 1 / (1 + law.decay));
  const T least = T{} + law.least_force;
  if (law.bounded) {
    speed_power(1, fast, factor, at.isoviscous_growth);
    at.isoviscous = law.isoviscous * factor;
    const T ratio = at.isoviscous / max(at.elastic, T{} + 1e-300);
    at.corner = power(max(ratio, T{} + 1e-60), 1 / (1 - kFilmForceExponent));
    at.corner_height = at.isoviscous / at.corner;
    at.corner_growth = (at.isoviscous_growth - at.elastic_growth) * (1 / (1 - kFilmForceExponent));
    at.least = film_thickness_above(law, at, least);
    const T upper = law.depth_of_newton * power(1.5 * at.corner, law.depth_exponent);
    at.elastic_above = upper - 1e6 * at.corner_height * kCornerEnd;
    at.rigid_below = upper * law.corner_lower - 1.5e6 * at.corner_height;
  } else {
    at.isoviscous = at.isoviscous_growth = at.corner = at.corner_height = at.corner_growth = T{};
    at.least = at.elastic * law.least_root;
    at.rigid_below = at.elastic_above = T{} - kNoFilm;
  }
  at.light_below = law.least_depth - 1e6 * at.least;
  const auto slopes = film_slopes_above(law, at, least, at.least);
  at.least_compliance = slopes.compliance;
  at.least_by_speed = slopes.by_speed;
  at.least_compliance_by_speed = slopes.compliance_by_speed;
  return at;
}

/// h [m].
template <class T>
T film_thickness(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q) {
  const T least = T{} + law.least_force;
  return select(Q < least, at.least + at.least_compliance * (least - Q),
                film_thickness_above(law, at, max(Q, least)));
}

template <class T>
FilmSlopes<T> film_slopes(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q, T h) {
  const T least = T{} + law.least_force;
  const auto light = Q < least;
  FilmSlopes<T> s = film_slopes_above(law, at, max(Q, least), h);
  s.compliance = select(light, at.least_compliance, s.compliance);
  s.bend = select(light, T{}, s.bend);
  s.by_speed =
      select(light, at.least_by_speed + at.least_compliance_by_speed * (least - Q), s.by_speed);
  s.compliance_by_speed = select(light, at.least_compliance_by_speed, s.compliance_by_speed);
  return s;
}

/// Thickest film at this speed, at Q = 0 [m].
template <class T>
T thickest_film(const FilmLaw& law, const FilmAtSpeed<T>& at) {
  return at.least + at.least_compliance * law.least_force;
}

/// Integral of Q k dQ above least_force, but for a constant [J].
template <class T>
T film_energy_above(const FilmLaw& law, const FilmAtSpeed<T>& at, T Q, T h) {
  constexpr double share = kFilmForceExponent / (1 - kFilmForceExponent);
  const T elastic = share * h * Q;
  if (!law.bounded) return elastic;
  const T size = at.corner * at.corner_height;
  const T l = kLn2 * log2(Q / at.corner);
  // In the corner by Gauss and Legendre on four points of ln Q.
  const T half = 0.5 * (min(max(l, T{} - kCorner), T{} + kCorner) + kCorner);
  T within{};
  for (int i = 0; i < 4; ++i) {
    constexpr double node[] = {-0.86113631159405258, -0.33998104358485626, 0.33998104358485626,
                               0.86113631159405258},
                     weight[] = {0.34785484513745386, 0.65214515486254614, 0.65214515486254614,
                                 0.34785484513745386};
    const T x = half * (1 + node[i]) - kCorner;
    within +=
        weight[i] * half * (kCornerMiddle - 2 * kCornerTurn * x) *
        exp2(((kCornerTurn * (x * x + kCorner * kCorner) + (1 - kCornerMiddle) * x)) * (1 / kLn2));
  }
  const T beyond = elastic - share * size * (1.5 * kCornerEnd);
  return select(l < -kCorner, at.isoviscous * (l + kCorner),
                size * within + select(l < kCorner, T{}, beyond));
}

}  // namespace cagetol
