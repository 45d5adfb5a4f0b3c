// Oil film between roller and race, in series with the elastic contact:
//   h = 2.65 alpha^0.54 (eta0 u)^0.70 R^0.43 E'^-0.03 (Q/l)^-0.13         Dowson and Higginson,
//   p = delta(Q) - h(Q, u),   1/K = 1/K_r + 1/K_o,   K_o = -dQ/dh = Q/(0.13 h)     line contact
// p geometric penetration [m], Q normal force [N], delta elastic depth [m], u mean entrainment
// speed [m/s], l contact length [m], R effective radius [m], E' effective modulus [Pa], eta0
// viscosity at ambient pressure [Pa s], alpha pressure-viscosity coefficient [1/Pa]. The formula is
// least valid for light loads: below `least_force` h goes on along its tangent to a finite film at
// Q = 0. The film carries load at p > -h(0, u). Source: Dowson and Higginson, Elasto-hydrodynamic
// Lubrication (1966), minimum film; Xin et al. 2024 (doi 10.3390/app14209433) eqs. for K_o, whose
// text lost minus signs and l.
#pragma once

#include "src/contact/normal_force.hpp"

namespace cagetol {

struct FilmLaw {
  bool on = false;
  double thickness = 0;    ///< h at 1 N and 1 m/s [m]
  double least_force = 0;  ///< [N]
};

/// Law of one of `slices` equal slices of a contact of `length` [m] and effective `radius` [m].
FilmLaw make_film_law(const OilFilm& film, double modulus, double radius, double length,
                      long slices);

inline constexpr double kFilmForceExponent = 0.13;
inline constexpr double kNoFilm = 1e30;  ///< stands for a film where nothing touches [m]

template <class T>
struct Film {
  T thickness;   ///< h [m]
  T compliance;  ///< 1/K_o = -dh/dQ [m/N]
};

/// `speed_factor` = u^0.7.
template <class T>
Film<T> oil_film(const FilmLaw& law, T force, T speed_factor) {
  const T least = T{} + law.least_force, within = max(force, least);
  const T h = law.thickness * speed_factor * power(within, -kFilmForceExponent);
  const T compliance = kFilmForceExponent * h / within;
  return {h + compliance * (least - min(force, least)), compliance};
}

/// u^0.7, and 0 for u = 0.
template <class T>
T film_speed_factor(T speed) {
  const auto moving = speed > 1e-12;
  return select(moving, power(select(moving, speed, T{} + 1.0), 0.7), T{});
}

/// Thickest film the law can give at this speed, at Q = 0 [m].
template <class T>
T thickest_film(const FilmLaw& law, T speed_factor) {
  return oil_film(law, T{}, speed_factor).thickness;
}

template <class T>
struct FilmContact {
  NormalForce<T> normal;  ///< by the geometric penetration and its rate
  T depth;                ///< delta [m]
  T thickness;            ///< h [m], anything where nothing is carried
};

/// The two in series; nothing is carried below p = -thickest_film.
template <class T>
FilmContact<T> film_contact(const NormalLaw& law, const FilmLaw& film, T p, T rate,
                            T speed_factor) {
  const T shallow = T{} + 1e-15;  // [m]
  const auto carrying = p > -thickest_film(film, speed_factor);
  // delta - h(Q(delta)) - p rises with delta, and bends little.
  T depth = max(p, shallow);
  for (int i = 0; i < 12; ++i) {
    const auto contact = normal_force(law, depth, T{});
    const auto h = oil_film(film, contact.elastic, speed_factor);
    const T before = depth;
    depth =
        max(depth - (depth - h.thickness - p) / (1.0 + contact.elastic_stiffness * h.compliance),
            shallow);
    if (!any(max(depth - before, before - depth) > 1e-9 * depth))
      break;  // quadratic: the error left is its square
  }
  const auto elastic = normal_force(law, depth, T{});
  const auto h = oil_film(film, elastic.elastic, speed_factor);
  const T share = 1.0 / (1.0 + elastic.elastic_stiffness * h.compliance);  // d delta/d p
  auto normal = normal_force(law, select(carrying, depth, T{} - 1.0), share * rate);
  normal.stiffness = normal.stiffness * share;
  normal.damping = normal.damping * share;
  normal.elastic_stiffness = normal.elastic_stiffness * share;
  return {normal, depth, h.thickness};
}

/// Stored in contact and film [J]: elastic, and the integral of Q/K_o dQ on the tangent and above
/// it; none where nothing is carried.
template <class T>
T film_energy(const NormalLaw& law, const FilmLaw& film, const FilmContact<T>& contact,
              T speed_factor) {
  const T Q = contact.normal.elastic, least = T{} + film.least_force, low = min(Q, least),
          high = max(Q, least);
  const auto at_least = oil_film(film, least, speed_factor),
             at_high = oil_film(film, high, speed_factor);
  const T in_film = 0.5 * low * low * at_least.compliance +
                    kFilmForceExponent / (1 - kFilmForceExponent) *
                        (at_high.thickness * high - at_least.thickness * least);
  return Q * contact.depth * (1 / (law.exponent + 1)) + in_film;
}

}  // namespace cagetol
