// Drag of oil and air on rollers and cage (src/lubrication/churning.hpp), with its derivatives.
#pragma once

#include "src/contacts/contact_frame.hpp"

namespace cagetol {

/// Left out of the derivatives: a roller's drag by the speed of the cage, whose fluid it runs in.
template <bool linear>
void roller_churning(const Churning& law, const RollerGroup& roller, const RollerPack& q,
                     const BorderState& b, RollerLoads& loads, GroupLinear* jac,
                     Observation* seen) {
  const Pack v = q.vt - law.carried_along * b.phi_rate * q.r,
             drag = law.roller * roller.exists * v * abs(v);
  loads.f[kLt] -= drag;
  if constexpr (linear) {
    const Pack slope = 2.0 * law.roller * roller.exists * abs(v),
               turn = q.omega - law.carried_along * b.phi_rate;
    seen->rub(kChurning, sum(drag * q.vt));
    jac->velocity[kLt][kLt] -= slope;
    // The force turns with the orbit; add_inertial takes it for held still and does it again.
    jac->position[kLr][kLt] += drag / q.r;
    jac->position[kLt][kLr] -= slope * turn;
    const Pack power = slope * q.vt + drag;
    jac->power_velocity[kLt] -= power;
    jac->power_position[kLt] += power * q.vr / q.r;
    jac->power_position[kLr] += slope * q.vt * (law.carried_along * b.phi_rate);
  }
}

template <bool linear>
void churn_cage(const Churning& law, const BorderState& b, BorderLoads& border, Linearisation* jac,
                Observation* seen) {
  if constexpr (linear) {
    using D = Dual<double, 1>;
    const ChurningLoads<D> on =
        cage_churning(law, variable<D>(b.phi_rate, 0), b.speed.inner, b.speed.outer);
    border.cage[3] += on.cage.value;
    jac->cage_touched = true;
    jac->border_velocity(kCagePhi, kCagePhi) += on.cage.slope[0];
    jac->power_velocity[kCagePhi] -=
        on.lost.slope[0] + on.inner.slope[0] * b.speed.inner + on.outer.slope[0] * b.speed.outer;
    seen->drive_power -= on.inner.value * b.speed.inner + on.outer.value * b.speed.outer;
    seen->rub(kChurning, on.lost.value);
  } else {
    border.cage[3] += cage_churning(law, b.phi_rate, b.speed.inner, b.speed.outer).cage;
  }
}

}  // namespace cagetol
