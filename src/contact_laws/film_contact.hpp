// Elastic contact and oil film in series (oil_film.hpp): the depth behind a geometric penetration,
//   p = delta - h(Q(delta), u),
// and what follows for force, its derivatives and stored energy. The two parts of the film are
// told apart by p, each solved by Halley's steps from a start of its own, so that two are enough;
// lanes only pay for parts that one of them is in. Depths are right to 1e-10 of themselves.
#pragma once

#include "src/contact_laws/oil_film.hpp"

namespace cagetol {

/// log2 of delta/d, to some 1e-6 of delta.
template <class T>
T film_depth_start(const FilmLaw& law, T ratio) {
  const FilmStart& table = law.start;
  T share;
  const T inside = min(max(ratio, T{} + FilmStart::kFrom), T{} + (FilmStart::kTo - 1e-9));
  const auto node = cell((inside - FilmStart::kFrom) * FilmStart::kPerUnit, share);
  const T a = gather(table.value.data(), node), b = gather(table.value.data() + 1, node);
  const T da = gather(table.slope.data(), node), db = gather(table.slope.data() + 1, node);
  const T rise = b - a, back = 1.0 - share;
  T s = a + share * (rise + back * (back * (da - rise) - share * (db - rise)));
  const auto deep = ratio > FilmStart::kTo, light = ratio < FilmStart::kFrom;
  if (any(deep | light)) {
    const T r = select(deep, ratio, T{} + 1.0), g = power(r, -law.decay);
    s = select(deep, log2(r + g * (1.0 - law.decay * g / r)), s);
    s = select(light, log2(select(light, -ratio, T{} + 1.0)) * (-1 / law.decay), s);
  }
  return s;
}

/// Halley's step of f = 0 for a depth, which stays positive. It cubes the error: steps below
/// kLastStep of the depth leave 1e-13 of it.
inline constexpr double kLastStep = 1e-4;
template <class T>
T halley_step(T x, T f, T slope, T bend) {
  const T square = slope * slope;
  return max(x - f * slope / max(square - 0.5 * f * bend, 0.5 * square), 0.05 * x);
}

/// delta [m] of p = delta - h, where anything is carried. One function: two branches of one curve,
/// each with its start and its iteration, of which lanes of a pack take different ones.
template <class T>
T film_depth(const NormalLaw& law, const FilmLaw& film, const FilmAtSpeed<T>& at, T penetration) {
  constexpr int most = 20;
  const T p = penetration * 1e6;
  const T along = p + 1e6 * thickest_film(film, at);
  const auto carrying = along > 0.0, light = carrying & (p < at.light_below);
  const auto elastic = carrying & (p >= at.light_below);
  T depth = T{} + 1.0;
  const auto go_on = [&depth](auto lanes, T next) {
    const bool far = any(lanes & (abs(next - depth) > kLastStep * next));
    depth = select(lanes, next, depth);
    return far;
  };
  if (any(elastic)) {
    const T start = film_depth_start(film, p / at.depth);
    depth = select(elastic, exp2(start) * at.depth, depth);
    T h = exp2(-film.decay * start) * at.depth;
    for (int i = 0; i < most; ++i) {
      const T inverse = 1.0 / depth, bent = film.decay * h * inverse;
      if (!go_on(elastic,
                 halley_step(depth, depth - h - p, 1.0 + bent, -(1 + film.decay) * bent * inverse)))
        break;
      h = film.softness * at.elastic * power(depth, -film.decay);
    }
  }
  if (any(light)) {  // delta + k K delta^e = p + h(0), nearly a straight line
    const double e = law.exponent;
    const T pull = 1e6 * law.stiffness * at.minimum_compliance;
    depth = select(light, along / (1.0 + pull * __builtin_pow(film.minimum_depth, e - 1)), depth);
    for (int i = 0; i < most; ++i) {
      const T w = pull * power(depth, e - 1);
      if (!go_on(light, halley_step(depth, depth + w * depth - along, 1.0 + e * w,
                                    e * (e - 1) * w / depth)))
        break;
    }
  }
  return depth * 1e-6;
}

template <class T>
struct FilmContact {
  NormalForce<T> normal;         ///< by the geometric penetration and its rate
  T depth;                       ///< delta [m]
  T thickness;                   ///< h [m], anything where nothing is carried
  T by_speed, elastic_by_speed;  ///< dQ/du and of the elastic part [N s/m]
};

/// The two in series; nothing is carried below p = -thickest_film.
template <class T>
FilmContact<T> film_contact(const NormalLaw& law, const FilmLaw& film, const FilmAtSpeed<T>& at,
                            T p, T rate) {
  const auto carrying = p > -thickest_film(film, at);
  const T depth = select(carrying, film_depth(law, film, at, p), T{} - 1.0);
  const T h = depth - p;
  const auto elastic = normal_force(law, depth, T{});
  const auto s = film_slopes(film, at, max(elastic.elastic, T{} + 1e-300), h);
  const T share = 1.0 / (1.0 + elastic.elastic_stiffness * s.compliance);  // d delta/d p
  auto normal = normal_force(law, depth, share * rate);
  // p' of the elastic depth is share p', and the share changes with depth and speed.
  const T bend = s.bend * elastic.elastic_stiffness * elastic.elastic_stiffness +
                 s.compliance * elastic.elastic_stiffness * (law.exponent - 1) / depth;
  const T turn = -normal.damping * rate * share * share;
  const T deepening = share * s.by_speed;  // d delta/du
  FilmContact<T> contact{normal, depth, h, {}, {}};
  contact.normal.stiffness = share * (normal.stiffness + turn * bend);
  contact.normal.damping = normal.damping * share;
  contact.normal.elastic_stiffness = normal.elastic_stiffness * share;
  contact.by_speed = select(carrying,
                            deepening * (normal.stiffness + turn * bend) +
                                turn * s.compliance_by_speed * elastic.elastic_stiffness,
                            T{});
  contact.elastic_by_speed = select(carrying, deepening * normal.elastic_stiffness, T{});
  return contact;
}

/// Stored in contact and film [J]: elastic, and the integral of Q k dQ; none where nothing is
/// carried.
template <class T>
T film_energy(const NormalLaw& law, const FilmLaw& film, const FilmAtSpeed<T>& at,
              const FilmContact<T>& contact) {
  const T Q = contact.normal.elastic, minimum = T{} + film.minimum_force, low = min(Q, minimum),
          high = max(Q, minimum);
  const T on_tangent = 0.5 * low * low * at.minimum_compliance;
  const T thickness = select(Q < minimum, at.minimum, contact.thickness);
  const T above = film_energy_above(high, thickness) - film_energy_above(minimum, at.minimum);
  return Q * contact.depth * (1 / (law.exponent + 1)) + on_tangent + above;
}

}  // namespace cagetol
