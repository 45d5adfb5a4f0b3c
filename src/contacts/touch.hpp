// A touch: where and how a contact point meets its partner, and what a dry contact law with
// friction answers. Each kind of contact finds its touches from the state; force, friction, account
// of energy and slopes are made here for all of them.
#pragma once

#include "src/model/observation.hpp"
#include "src/newton/linearisation.hpp"

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

/// What the derivatives need of a touch.
inline ContactSlopes slopes_of(const Touch<double>& touch, const Answer<double>& on) {
  return {on.normal.force,   on.normal.stiffness, on.normal.damping,
          on.friction.ratio, on.friction.bend,    touch.v1,
          touch.v2,          on.normal.elastic,   on.normal.elastic_stiffness,
          touch.rate};
}
/// Of one lane.
inline ContactSlopes slopes_of(const Touch<Pack>& touch, const Answer<Pack>& on, int lane) {
  const int i = lane;
  return {on.normal.force[i],   on.normal.stiffness[i], on.normal.damping[i],
          on.friction.ratio[i], on.friction.bend[i],    touch.v1[i],
          touch.v2[i],          on.normal.elastic[i],   on.normal.elastic_stiffness[i],
          touch.rate[i]};
}

}  // namespace cagetol
