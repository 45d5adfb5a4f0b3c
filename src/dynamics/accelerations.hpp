// Rates of the state from the loads on the bodies (Newton and Euler; src/NOTATION.md).
#pragma once

#include "src/contacts/contact_frame.hpp"

namespace cagetol {
namespace {  // each source compiles its own

/// Accelerations of a pack of rollers from its loads; velocities into the position rates.
void store_rates(const BearingModel& m, const RollerGroup& roller, const RollerPack& q,
                 const RollerLoads& loads, const double* y, double* rate, int group) {
  const StateLayout& l = m.layout;
  const int j = group * kLanes;
  const auto velocity = [&](RollerVelocity slot) { return load(y + l.velocity(slot, j)); };
  const auto put = [&](int slot, Pack value) { store(rate + slot, value * roller.exists); };
  put(l.position(kRadius, j), velocity(kRadialSpeed));
  put(l.position(kAngle, j), velocity(kOrbitRate));
  put(l.position(kAxial, j), velocity(kAxialSpeed));
  put(l.position(kAxisY, j), velocity(kAxisRateY));
  put(l.position(kAxisZ, j), velocity(kAxisRateZ));
  const Pack gravity_r = -m.gravity * q.sine, gravity_t = -m.gravity * q.cosine;
  put(l.velocity(kRadialSpeed, j), loads.f[kLr] * roller.inverse_mass + gravity_r + q.vt * q.omega);
  put(l.velocity(kOrbitRate, j),
      (loads.f[kLt] * roller.inverse_mass + gravity_t - 2.0 * q.vr * q.omega) / q.r);
  put(l.velocity(kSpin, j), loads.f[kLs] * roller.inverse_polar);
  put(l.velocity(kAxialSpeed, j), loads.f[kLx] * roller.inverse_mass - m.gravity_axial);
  const Pack gyro = roller.polar * q.spin;
  const Pack lean_r = (loads.f[kLar] - gyro * q.b_t) * roller.inverse_transverse;
  const Pack lean_t = (loads.f[kLat] + gyro * q.b_r) * roller.inverse_transverse;
  put(l.velocity(kAxisRateY, j), q.cosine * lean_r - q.sine * lean_t);
  put(l.velocity(kAxisRateZ, j), q.sine * lean_r + q.cosine * lean_t);
}

/// `modal_force`: of the contacts on the elastic modes.
void store_border_rates(const BearingModel& m, double t, const BorderState& b,
                        const BorderLoads& loads, const double* modal_force, const double* y,
                        double* rate) {
  const double* v = y + m.layout.border_velocity(0);
  double *dq = rate + m.layout.border_position(0), *dv = rate + m.layout.border_velocity(0);
  for (int i = 0; i < m.layout.border(); ++i) dq[i] = v[i];
  for (int i = m.layout.border(); i < m.layout.padded_border(); ++i) dq[i] = dv[i] = 0;
  const RingLoad load = load_at(m.duty, t);
  dv[kRingY] = (loads.ring[0] + load.y) / m.ring_mass;
  dv[kRingZ] = (loads.ring[1] + load.z) / m.ring_mass - m.gravity;
  if (m.layout.ring_axial > 0)
    dv[m.layout.ring_axial_slot()] =
        (loads.ring_axial + load.axial) / m.ring_mass - m.gravity_axial;
  if (m.layout.ring_tilt > 0) {
    const int tilt = m.layout.ring_tilt_slot();
    const double gyro = m.ring_polar * b.speed.inner;
    const double held_y = m.tilt_stiffness * (b.tilt[0] - m.misalignment_y),
                 held_z = m.tilt_stiffness * (b.tilt[1] - m.misalignment_z);
    const double moment_y = loads.tilt[0] + load.moment_y - held_y - gyro * b.tilt_rate[1],
                 moment_z = loads.tilt[1] + load.moment_z - held_z + gyro * b.tilt_rate[0];
    dv[tilt] = moment_y / m.ring_transverse;
    dv[tilt + 1] = moment_z / m.ring_transverse;
  }
  dv[kCageY] = loads.cage[0] / m.cage_mass;
  dv[kCageZ] = loads.cage[1] / m.cage_mass - m.gravity;
  dv[kCageX] = loads.cage[2] / m.cage_mass - m.gravity_axial;
  // Moment about the mass centre: the forces act about the geometric centre, at -e from it.
  const double torque =
      loads.cage[3] + loads.cage[0] * b.unbalance[1] - loads.cage[1] * b.unbalance[0];
  dv[kCagePhi] = torque / m.cage_polar;
  const double gyro = m.cage_polar * b.phi_rate;
  dv[kCageAxisY] = (loads.cage[4] - gyro * b.axis_rate[1]) / m.cage_transverse;
  dv[kCageAxisZ] = (loads.cage[5] + gyro * b.axis_rate[0]) / m.cage_transverse;
  if (m.layout.modes == 0) return;
  const double* q = y + m.layout.border_position(0);
  for (int k = 0; k < m.layout.modes; ++k) {
    const auto at = static_cast<std::size_t>(k);
    dv[kModes + k] = modal_force[k] - m.flexible.stiffness[at] * q[kModes + k] -
                     m.flexible.damping[at] * v[kModes + k];
  }
  couple_spin(m.flexible, m.cage_polar, b.phi_rate, q + kModes, v + kModes, dv + kModes,
              dv[kCagePhi]);
}

}  // namespace
}  // namespace cagetol
