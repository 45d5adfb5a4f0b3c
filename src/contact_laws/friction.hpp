// Friction of one contact, Adams' law, v the sliding velocity vector in the contact plane (not
// component by component):
//
//   F = -mu(|v|) Q v/|v|
//   mu(v) = STEP(v, -v_s, -mu_s, v_s, mu_s)   v <  v_s         = mu_s (3 s - s^3)/2 with s = v/v_s
//         = STEP(v,  v_s,  mu_s, v_d, mu_d)   v_s <= v < v_d
//         = mu_d                              v >= v_d
// mu(0) = 0: true sticking does not exist, contacts creep, and slip figures depend on v_s and v_d.
// Source: MSC Adams CONTACT; Xin et al. 2024 (doi 10.3390/app14209433) eqs. (6)-(7), whose text
// lost the minus signs.
#pragma once

#include "src/contact_laws/step.hpp"

namespace cagetol {

struct FrictionLaw {
  double static_coefficient = 0.07;   ///< mu_s
  double dynamic_coefficient = 0.06;  ///< mu_d
  double static_speed = 0.1;          ///< v_s [m/s]
  double dynamic_speed = 1.0;         ///< v_d [m/s]
};

template <class T>
struct Friction {
  T ratio;  ///< mu/|v| [s/m]: F = -ratio Q v
  T bend;   ///< (dmu/dv - mu/v)/v^2: dF/dv = -Q (ratio I + bend v v^T)
};

/// `speed_squared` = |v|^2 [m^2/s^2].
template <class T>
[[gnu::always_inline]] inline Friction<T> friction(const FrictionLaw& law, T speed_squared) {
  const double vs = law.static_speed, mu_s = law.static_coefficient;
  const T s2 = speed_squared * (1.0 / (vs * vs));
  Friction<T> f{(mu_s / (2 * vs)) * (3.0 - s2), T{} + (-mu_s / (vs * vs * vs))};
  const auto fast = s2 >= 1.0;
  if (any(fast)) {
    const double span = law.dynamic_speed - vs, change = law.dynamic_coefficient - mu_s;
    const T v = sqrt(max(speed_squared, T{} + vs * vs));
    const T z = (v - vs) * (1.0 / span);
    const T mu = mu_s + change * smooth_step(z);
    const T slope = (change / span) * smooth_step_slope(z);
    const T inverse = 1.0 / v;
    f.ratio = select(fast, mu * inverse, f.ratio);
    f.bend = select(fast, (slope - mu * inverse) * inverse * inverse, f.bend);
  }
  return f;
}

}  // namespace cagetol
