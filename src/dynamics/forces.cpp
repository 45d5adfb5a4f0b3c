#include "src/dynamics/forces.hpp"

#include "src/dynamics/evaluate.hpp"

namespace cagetol {

void evaluate_rates(const BearingModel& model, double t, const double* y, double* rate) {
  const Evaluation with = !model.forms.round ? wavy_rates(model)
                          : model.lubricated ? lubricated_rates(model)
                                             : evaluation_as<false, false>(model);
  with(model, t, y, rate, nullptr, nullptr);
}

void linearise(const BearingModel& model, double t, const double* y, double* rate,
               Linearisation& linear, Observation& seen) {
  const Evaluation with = !model.forms.round ? wavy_linearisation(model)
                          : model.lubricated ? lubricated_linearisation(model)
                                             : evaluation_as<true, false>(model);
  with(model, t, y, rate, &linear, &seen);
}

double body_energy(const BearingModel& m, const double* y) {
  double energy = 0;
  for (int group = 0; group < m.layout.groups; ++group) {
    const RollerGroup& roller = m.groups[static_cast<std::size_t>(group)];
    const RollerPack q = unpack_rollers(m.layout, y, group);
    energy +=
        sum(roller.exists * (0.5 * roller.mass * (q.vr * q.vr + q.vt * q.vt + q.vx * q.vx) +
                             0.5 * roller.transverse * (q.b_r * q.b_r + q.b_t * q.b_t) +
                             0.5 * roller.polar * q.spin * q.spin +
                             roller.mass * (m.gravity * q.r * q.sine + m.gravity_axial * q.x)));
  }
  const double *q = y + m.layout.border_position(0), *v = y + m.layout.border_velocity(0);
  const auto square = [&](int slot) { return v[slot] * v[slot]; };
  energy +=
      0.5 * m.ring_mass * (square(kRingY) + square(kRingZ)) + m.ring_mass * m.gravity * q[kRingZ];
  if (m.layout.ring_axial > 0) {
    const int axial = m.layout.ring_axial_slot();
    energy += m.ring_mass * (0.5 * square(axial) + m.gravity_axial * q[axial]);
  }
  if (m.layout.ring_tilt > 0) {
    const int tilt = m.layout.ring_tilt_slot();
    const double bent_y = q[tilt] - m.misalignment_y, bent_z = q[tilt + 1] - m.misalignment_z;
    energy += 0.5 * m.ring_transverse * (square(tilt) + square(tilt + 1)) +
              0.5 * m.tilt_stiffness * (bent_y * bent_y + bent_z * bent_z);
  }
  energy += 0.5 * m.cage_mass * (square(kCageY) + square(kCageZ) + square(kCageX)) +
            m.cage_mass * (m.gravity * q[kCageZ] + m.gravity_axial * q[kCageX]);
  energy += 0.5 * m.cage_polar * square(kCagePhi) +
            0.5 * m.cage_transverse * (square(kCageAxisY) + square(kCageAxisZ));
  if (m.layout.modes > 0) energy += modal_energy(m.flexible, v[kCagePhi], q + kModes, v + kModes);
  return energy;
}

}  // namespace cagetol
