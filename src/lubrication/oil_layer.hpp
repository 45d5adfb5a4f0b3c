// What is left of a film whose inlet a meniscus cuts short, where the gap is `layer` wide. It thins
// the elastic part of the film,
//
//   h' = h (r + (1 - r)/(1 + y sqrt(y/(y + 0.045)))),   r = (h_I/h)^4,   y = (1 - r) h/layer
//
// (heavy loads: r = 0, y = h_E/layer), and leaves of its other terms, x = h'/layer,
//
//   wedge    (1 - x)^2 (1 - 0.3 x)
//   squeeze  (1 - x^1.5)^1.5 (1 - 0.1 x^1.5)
//   rolling  (1 - sqrt x)^2 (1 - 0.8 x^1.5)
//   Couette  sqrt(1 - sqrt x) S(min(1, (1 - x)/0.2)),   S cubic (src/contact_laws/step.hpp)
//
// and nothing from x = 1 on; C1 there. No gap wider than the layer has an inlet: from half of it on
// all fades, x -> 1 - (1 - x) S(2 - 2 g/layer), and with it the load of the elastic part.
//
// Sources: Grubin's inlet of an elastic line contact cut at the meniscus, whose integral h' follows
// within 3 %; for the factors Reynolds' equation of a cylinder against a plane with the same
// meniscus, within 0.01 (Couette 0.02), the elastic inlet's rolling force within 0.08
// (tests/unit/src/oil_layer_test.cpp).
#pragma once

#include "src/contact_laws/step.hpp"
#include "src/numerics/dual.hpp"

namespace cagetol {

template <class T>
struct OilFactors {
  T wedge, squeeze, rolling, couette;
};

/// `x` > 0.
template <class T>
OilFactors<T> oil_factors(T x) {
  const auto wet = x < 1.0;
  // Beyond the layer the factors are those of a place within it, masked: no root is taken of a
  // number that is not positive.
  const T inside = select(wet, x, T{} + 0.5), zero{};
  const T root = inside * inverse_root(inside), more = inside * root;  // x^1.5
  const T rest = 1.0 - inside, across = 1.0 - root, left = 1.0 - more;
  const T z = min(rest * 5.0, T{} + 1.0);
  const auto of_wet = [&](T factor) { return select(wet, factor, zero); };
  return {of_wet(rest * rest * (1.0 - 0.3 * inside)),
          of_wet(left * left * inverse_root(left) * (1.0 - 0.1 * more)),
          of_wet(across * across * (1.0 - 0.8 * more)),
          of_wet(across * inverse_root(across) * z * z * (3.0 - 2.0 * z))};
}

/// A film with a layer.
template <class T>
struct LayeredFilm {
  T thickness;       ///< h' [m]
  T load;            ///< share of the flooded film's steady load, in [0, 1]
  OilFactors<T> of;  ///< the film's other terms
};

/// Of a film as if flooded: nothing is cut.
template <class T>
LayeredFilm<T> flooded(T thickness) {
  const T one = T{} + 1.0;
  return {thickness, one, {one, one, one, one}};
}

/// `thickness` and `rigidity` = (h_I/h)^4 of the flooded film, `gap` of the undeformed bodies [m].
template <class T, class G>
LayeredFilm<T> layered(T thickness, T rigidity, G gap, double layer) {
  const T x = thickness * (1 / layer), elasticity = 1.0 - rigidity;
  const T y = x * elasticity + 1e-12;
  const T thinner = reciprocal(1.0 + y * (y * inverse_root(y * (y + 0.045))));
  const T left = rigidity + elasticity * thinner;
  const G z = max(min(2.0 - gap * (2 / layer), G{} + 1.0), G{});
  const G near = z * z * (3.0 - 2.0 * z);
  LayeredFilm<T> film;
  film.thickness = thickness * left;
  film.of = oil_factors(1.0 - (1.0 - x * left) * near);
  film.load = rigidity * film.of.wedge + elasticity * near;
  return film;
}

}  // namespace cagetol
