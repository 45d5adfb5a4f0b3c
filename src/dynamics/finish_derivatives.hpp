// What completes the derivatives of the contacts (forces.cpp): frames that turn, inertial terms,
// what the rollers' share in the inner race means for the ring, and the own terms of ring and cage.
#pragma once

#include "src/contacts/turned_frame.hpp"

namespace cagetol {
namespace {  // forces.cpp alone uses these, and inlines what pays

/// Begins the derivatives of a pack of rollers: directions and radius.
GroupLinear* start_group(const RollerPack& q, int group, Linearisation& jac) {
  GroupLinear& g = jac.groups[static_cast<std::size_t>(group)];
  g.cosine = q.cosine;
  g.sine = q.sine;
  g.radius = q.r;
  g.inverse_radius = 1.0 / q.r;
  return &g;
}

/// Rate of the net power along the motion, in frozen directions: gradient times velocities and
/// accelerations.
double roller_power_rate(const RollerGroup& roller, const RollerPack& q, const RollerLoads& loads,
                         const BearingModel& m, const GroupLinear& g) {
  const Pack gyro = roller.polar * q.spin;
  const Pack acceleration[kLocalVelocities] = {
      loads.f[kLr] * roller.inverse_mass - m.gravity * q.sine,
      loads.f[kLt] * roller.inverse_mass - m.gravity * q.cosine,
      loads.f[kLx] * roller.inverse_mass - m.gravity_axial,
      (loads.f[kLar] - gyro * q.b_t) * roller.inverse_transverse,
      (loads.f[kLat] + gyro * q.b_r) * roller.inverse_transverse,
      loads.f[kLs] * roller.inverse_polar};
  const Pack velocity[kLocalPositions] = {q.vr, q.vt, q.vx, q.b_r, q.b_t};
  Pack change{};
  for (int i = 0; i < kLocalVelocities; ++i) change += g.power_velocity[i] * acceleration[i];
  for (int i = 0; i < kLocalPositions; ++i) change += g.power_position[i] * velocity[i];
  return sum(change * roller.exists);
}

/// Inertial terms of the polar coordinates and the gyroscopic moment, as derivatives of forces.
void add_inertial(const BearingModel& m, const RollerGroup& roller, const RollerPack& q,
                  const RollerLoads& loads, GroupLinear& g) {
  const Pack mass = roller.mass;
  const Pack F_r = loads.f[kLr] - mass * m.gravity * q.sine,
             F_t = loads.f[kLt] - mass * m.gravity * q.cosine;
  g.position[kLr][kLr] += mass * q.omega * q.omega;
  g.position[kLr][kLt] += F_t / q.r;  // F_r turns with theta
  g.velocity[kLr][kLt] += 2.0 * mass * q.omega;
  // r theta'' = F_t/m - 2 r' omega: the row is m r d(theta'').
  const Pack orbit_acceleration = (F_t - 2.0 * mass * q.vr * q.omega) / q.r;
  g.position[kLt][kLr] -= orbit_acceleration;
  g.position[kLt][kLt] -= F_r / q.r;
  g.velocity[kLt][kLr] -= 2.0 * mass * q.omega;
  g.velocity[kLt][kLt] -= 2.0 * mass * q.vr / q.r;
  const Pack gyro = roller.polar * q.spin;
  g.velocity[kLar][kLat] -= gyro;
  g.velocity[kLar][kLs] -= roller.polar * q.b_t;
  g.velocity[kLat][kLar] += gyro;
  g.velocity[kLat][kLs] += roller.polar * q.b_r;
}

/// Likewise of the ring's tilt: moments on the ring, and its displacement with the tilt. Then what
/// the rollers' frames do to the moments.
void finish_tilt(const RollerPack& q, const GroupLinear& g, int slot, TiltLinear& tilt,
                 Linearisation& linear) {
  RingCoupling& c = tilt.coupling;
  const auto add = [&](const Pack(&own)[2][2], const Pack(&by_tilt)[kLocalVelocities][2],
                       const Pack* moment_r, const Pack* moment_t, Eigen::MatrixXd& block) {
    add_turned(g, own[0][0], own[0][1], own[1][0], own[1][1], block, slot, slot);
    add_turned(g, -by_tilt[kLr][0], -by_tilt[kLr][1], -by_tilt[kLt][0], -by_tilt[kLt][1], block,
               kRingY, slot);
    add_turned(g, -moment_r[kLr], -moment_r[kLt], -moment_t[kLr], -moment_t[kLt], block, slot,
               kRingY);
  };
  add(tilt.position, c.position, c.to_position[0], c.to_position[1], linear.border_position);
  add(tilt.velocity, c.velocity, c.to_velocity[0], c.to_velocity[1], linear.border_velocity);
  for (int k = 0; k < 2; ++k) turn_frame(q, c.to_position[k], c.to_velocity[k]);
}

/// The cage's own derivatives: gyroscopic moment, elastic modes, and what the spin does to these.
/// To be called before contacts add theirs.
void set_cage_block(const BearingModel& m, const BorderState& b, const double* y,
                    Linearisation& linear, Observation& seen) {
  const double gyro = m.cage_polar * b.phi_rate;
  linear.border_velocity(kCageAxisY, kCageAxisZ) = -gyro;
  linear.border_velocity(kCageAxisZ, kCageAxisY) = gyro;
  linear.border_velocity(kCageAxisY, kCagePhi) = -m.cage_polar * b.axis_rate[1];
  linear.border_velocity(kCageAxisZ, kCagePhi) = m.cage_polar * b.axis_rate[0];
  const FlexibleCage& flexible = m.flexible;
  const int modes = flexible.modes;
  if (flexible.centrifugal) seen.centrifugal_spin = b.phi_rate;
  if (modes == 0) return;
  const double* v = y + m.layout.border_velocity(kModes);
  // Leading terms of the coupling with the spin; what they leave out is smaller by displacement
  // over radius.
  const double spin = b.phi_rate;
  auto among = linear.border_velocity.block(kModes, kModes, modes, modes);
  auto by_spin = linear.border_velocity.col(kCagePhi).segment(kModes, modes);
  if (flexible.coriolis) {
    among.noalias() = -2 * spin * flexible.model->gyroscopic;
    double turned[kMostModes];
    flexible.gyroscopic.multiply(v, turned);
    by_spin = -2 * Eigen::Map<const Eigen::VectorXd>(turned, modes);
  } else {
    among.setZero();
    by_spin.setZero();
  }
  if (flexible.centrifugal) {
    by_spin += 2 * spin * flexible.model->centrifugal;
    linear.border_velocity.row(kCagePhi).segment(kModes, modes) =
        -2 * spin * flexible.model->centrifugal.transpose();
  }
  for (int k = 0; k < modes; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double damping = flexible.damping[at];
    linear.border_position(kModes + k, kModes + k) = -flexible.stiffness[at];
    among(k, k) -= damping;
    linear.power_velocity[kModes + k] -= 2 * damping * v[k];
    seen.damp(kDamping, damping * v[k] * v[k]);
  }
}

/// The shaft's hold on the ring's tilt, and the gyroscopic moment of the spinning ring.
void add_shaft_block(const BearingModel& m, const BorderState& b, Linearisation& linear) {
  const int tilt = m.layout.ring_tilt_slot();
  const double gyro = m.ring_polar * b.speed.inner;
  linear.border_velocity(tilt, tilt + 1) -= gyro;
  linear.border_velocity(tilt + 1, tilt) += gyro;
  for (int k = 0; k < 2; ++k) linear.border_position(tilt + k, tilt + k) -= m.tilt_stiffness;
}

}  // namespace
}  // namespace cagetol
