// A touch: where and how a contact point meets its partner, and what a dry contact law with
// friction answers. Each kind of contact finds its touches from the state; force, friction, account
// of energy and slopes are made here for all of them.
#pragma once

#include "src/model/observation.hpp"
#include "src/newton/linearisation.hpp"
#include "src/numerics/dual.hpp"

namespace cagetol {

/// T: Pack for rollers side by side, or double.
template <class T>
struct Touch {
  T p;       ///< penetration, > 0 in contact [m]
  T rate;    ///< p', > 0 while approaching [m/s]
  T v1, v2;  ///< sliding velocity of the first body relative to the second, two directions [m/s]
};

/// What a contact law with friction makes of a touch.
template <class T>
struct Answer {
  NormalForce<T> normal;
  Friction<T> friction;
  T squared;  ///< |v|^2 [m^2/s^2]
  T drag;     ///< friction force over sliding speed [N s/m]: F = -drag v
};

template <class T>
Answer<T> answer_to(const Touch<T>& touch, const NormalLaw& law, const FrictionLaw& rubbing) {
  Answer<T> on;
  on.normal = normal_force(law, touch.p, touch.rate);
  on.squared = touch.v1 * touch.v1 + touch.v2 * touch.v2;
  on.friction = friction(rubbing, on.squared);
  on.drag = on.friction.ratio * on.normal.force;
  return on;
}
/// The same where only the lanes `touching` count.
inline Answer<Pack> answer_to(const Touch<Pack>& touch, Mask touching, const NormalLaw& law,
                              const FrictionLaw& rubbing) {
  Touch<Pack> counted = touch;
  counted.p = select(touching, touch.p, splat(-1.0));
  return answer_to(counted, law, rubbing);
}

/// Powers and stored energy of a touch into the account; friction as that of `where`.
template <class T>
void account(const Touch<T>& touch, const Answer<T>& on, const NormalLaw& law, Mechanism where,
             Observation& seen) {
  const auto total = [](T each) {
    if constexpr (std::is_same_v<T, double>)
      return each;
    else
      return sum(each);
  };
  seen.rub(where, total(on.drag * on.squared));
  seen.damp(kDamping, total((on.normal.force - on.normal.elastic) * touch.rate));
  seen.elastic_energy += total(on.normal.elastic * max(touch.p, T{})) / (law.exponent + 1);
}

/// Forces of a touch along its channels [N], and the power that it takes [W]. T: Pack or double, or
/// with slopes by the variables of ContactSlopes.
template <class T>
struct ChannelForces {
  T normal, f1, f2, lost;
};
template <class T, class S>
ChannelForces<T> channel_forces(const Touch<S>& touch, T normal, T elastic, T drag) {
  using C = ContactSlopes;
  const T v1 = variable<T>(touch.v1, C::kV1), v2 = variable<T>(touch.v2, C::kV2), f1 = -drag * v1,
          f2 = -drag * v2;
  return {normal, f1, f2,
          (normal - elastic) * variable<T>(touch.rate, C::kRate) - f1 * v1 - f2 * v2};
}
/// An answer with its slopes: normal force, its elastic part, ratio of friction.
template <class T>
struct DryForces {
  T normal, elastic, ratio;
};
template <class T, class S>
DryForces<T> dry_forces(const Touch<S>& touch, const Answer<S>& on) {
  const NormalForce<S>& normal = on.normal;
  const Friction<S>& fr = on.friction;
  return {with_slopes<T>(normal.force, normal.stiffness, normal.damping),
          with_slopes<T>(normal.elastic, normal.elastic_stiffness),
          with_slopes<T>(fr.ratio, S{}, S{}, fr.bend * touch.v1, fr.bend * touch.v2)};
}
template <class S>
ChannelForces<Dual<S, 4>> channel_forces(const Touch<S>& touch, const Answer<S>& on) {
  const auto [normal, elastic, ratio] = dry_forces<Dual<S, 4>>(touch, on);
  return channel_forces(touch, normal, elastic, ratio * normal);
}

/// For add_contact; of packs one lane.
template <class T, int n>
ContactSlopes slopes_of(const ChannelForces<Dual<T, n>>& on, [[maybe_unused]] int lane = 0) {
  const auto at = [lane](const T& x) {
    if constexpr (std::is_same_v<T, Pack>)
      return x[lane];
    else
      return x;
  };
  ContactSlopes to;
  for (int z = 0; z < n; ++z) {
    to.force[z][0] = at(on.normal.slope[z]);
    to.force[z][1] = at(on.f1.slope[z]);
    to.force[z][2] = at(on.f2.slope[z]);
    to.power[z] = -at(on.lost.slope[z]);
  }
  return to;
}

}  // namespace cagetol
