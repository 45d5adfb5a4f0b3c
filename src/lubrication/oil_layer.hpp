// What is left of a film's terms where a gap holds only so much oil. x = h/layer, h the film
// thickness [m], `layer` the thickness of all oil in the gap [m]:
//
//   wedge    (1 - x)^2.3
//   squeeze  (1 - x^1.5)^1.6
//   rolling  (1 - sqrt x)^2.1
//   Couette  sqrt(1 - sqrt x) S(min(1, (1 - x)/0.2)),   S cubic (src/contact_laws/step.hpp)
//
// and zero from x = 1 on; C1 there. Source: solutions of Reynolds' equation for a cylinder against
// a plane whose inlet meniscus stands where the gap is `layer` wide, which these follow within
// 0.02.
#pragma once

#include "src/contact_laws/step.hpp"
#include "src/numerics/dual.hpp"

namespace cagetol {

template <class T>
struct OilFactors {
  T wedge, squeeze, rolling, couette;
};

/// Factors of a film whose gap is full of oil.
template <class T>
OilFactors<T> flooded() {
  const T one = T{} + 1.0;
  return {one, one, one, one};
}

/// `x` > 0.
template <class T>
OilFactors<T> oil_factors(T x) {
  const auto wet = x < 1.0;
  // Beyond the layer the factors are those of a place within it, masked, so that no power is taken
  // of a number that is not positive.
  const T inside = select(wet, x, T{} + 0.5);
  const T root = inside * inverse_root(inside), rest = 1.0 - inside, across = 1.0 - root;
  const T z = min(rest * 5.0, T{} + 1.0);
  const OilFactors<T> f{power(rest, 2.3), power(1.0 - inside * root, 1.6), power(across, 2.1),
                        across * inverse_root(across) * z * z * (3.0 - 2.0 * z)};
  const T zero{};
  return {select(wet, f.wedge, zero), select(wet, f.squeeze, zero), select(wet, f.rolling, zero),
          select(wet, f.couette, zero)};
}

}  // namespace cagetol
