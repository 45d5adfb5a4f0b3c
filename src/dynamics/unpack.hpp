// The state of the bearing unpacked into frames: packs of rollers in their own directions, inner
// ring and cage.
#pragma once

#include "src/contacts/contact_frame.hpp"

namespace cagetol {
namespace {  // each source compiles its own

RollerPack unpack_rollers(const StateLayout& l, const double* y, int group) {
  const int j = group * kLanes;
  RollerPack p;
  p.r = load(y + l.position(kRadius, j));
  sine_cosine(load(y + l.position(kAngle, j)), p.sine, p.cosine);
  p.vr = load(y + l.velocity(kRadialSpeed, j));
  p.omega = load(y + l.velocity(kOrbitRate, j));
  p.vt = p.r * p.omega;
  p.spin = load(y + l.velocity(kSpin, j));
  p.x = load(y + l.position(kAxial, j));
  const Pack ay = load(y + l.position(kAxisY, j)), az = load(y + l.position(kAxisZ, j));
  p.a_r = along_r(p, ay, az);
  p.a_t = along_t(p, ay, az);
  p.vx = load(y + l.velocity(kAxialSpeed, j));
  const Pack by = load(y + l.velocity(kAxisRateY, j)), bz = load(y + l.velocity(kAxisRateZ, j));
  p.b_r = along_r(p, by, bz);
  p.b_t = along_t(p, by, bz);
  return p;
}

BorderState unpack_border(const BearingModel& m, double t, const double* y) {
  const double *q = y + m.layout.border_position(0), *v = y + m.layout.border_velocity(0);
  BorderState b;
  const double phi = q[kCagePhi];
  b.phi = phi;
  Pack sine, cosine;  // a pack's costs less than the library's two
  sine_cosine(splat(phi), sine, cosine);
  b.phi_cos = cosine[0];
  b.phi_sin = sine[0];
  b.phi_rate = v[kCagePhi];
  turned_unbalance(m, b.phi_cos, b.phi_sin, b.unbalance);
  b.ring[0] = q[kRingY];
  b.ring[1] = q[kRingZ];
  b.ring_rate[0] = v[kRingY];
  b.ring_rate[1] = v[kRingZ];
  const bool floats = m.layout.ring_axial > 0;
  b.ring_axial = floats ? q[m.layout.ring_axial_slot()] : 0;
  b.ring_axial_rate = floats ? v[m.layout.ring_axial_slot()] : 0;
  const bool tilting = m.layout.ring_tilt > 0;
  const double misalignment[2] = {m.misalignment_y, m.misalignment_z};
  for (int k = 0; k < 2; ++k) {
    b.tilt[k] = tilting ? q[m.layout.ring_tilt_slot() + k] : misalignment[k];
    b.tilt_rate[k] = tilting ? v[m.layout.ring_tilt_slot() + k] : 0;
  }
  b.cage[0] = q[kCageY] - b.unbalance[0];
  b.cage[1] = q[kCageZ] - b.unbalance[1];
  b.cage[2] = q[kCageX];
  b.cage_rate[0] = v[kCageY] + b.phi_rate * b.unbalance[1];
  b.cage_rate[1] = v[kCageZ] - b.phi_rate * b.unbalance[0];
  b.cage_rate[2] = v[kCageX];
  b.axis[0] = q[kCageAxisY];
  b.axis[1] = q[kCageAxisZ];
  b.axis_rate[0] = v[kCageAxisY];
  b.axis_rate[1] = v[kCageAxisZ];
  b.speed = ring_speeds_at(m.duty, t);
  b.speeding_up = ring_accelerations_at(m.duty, t);
  if (!m.forms.round) b.turned = ring_angles_at(m.duty, t);
  return b;
}

}  // namespace
}  // namespace cagetol
