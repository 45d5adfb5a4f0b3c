#include "mc/run/history_channels.hpp"

#include <cmath>
#include <limits>

#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr double kUm = 1e6, kMrad = 1e3, kMPa = 1e-6;

const double* border(const Instant& at) {
  return at.y + at.system.model.layout.border_position(0);
}
const double* border_speed(const Instant& at) {
  return at.y + at.system.model.layout.border_velocity(0);
}
double roller_position(const Instant& at, RollerPosition slot, int roller) {
  return at.y[at.system.model.layout.position(slot, roller)];
}
double roller_velocity(const Instant& at, RollerVelocity slot, int roller) {
  return at.y[at.system.model.layout.velocity(slot, roller)];
}

/// A point of the radial plane, or its velocity.
struct Plane {
  double y, z;
};

/// Mass centre minus geometric centre of the cage, fixed in space.
Plane unbalance(const Instant& at) {
  const double phi = border(at)[kCagePhi], c = std::cos(phi), s = std::sin(phi);
  const double e_y = at.system.model.unbalance_y, e_z = at.system.model.unbalance_z;
  return {c * e_y - s * e_z, s * e_y + c * e_z};
}

Plane cage_centre(const Instant& at) {
  const Plane e = unbalance(at);
  return {border(at)[kCageY] - e.y, border(at)[kCageZ] - e.z};
}

double cage_centre_speed(const Instant& at) {
  const Plane e = unbalance(at);
  const double* v = border_speed(at);
  return std::hypot(v[kCageY] + v[kCagePhi] * e.z, v[kCageZ] - v[kCagePhi] * e.y);
}

double ring_speed(const Instant& at) {
  return std::hypot(border_speed(at)[kRingY], border_speed(at)[kRingZ]);
}

double ring_acceleration(const Instant& at) {
  const double* dv = at.system.rate.data() + at.system.model.layout.border_velocity(0);
  return std::hypot(dv[kRingY], dv[kRingZ]);
}

/// Slope of the inner ring's centre line in y (k = 0) or z (1).
double ring_tilt(const Instant& at, int k) {
  const BearingModel& m = at.system.model;
  if (m.layout.ring_tilt > 0) return border(at)[m.layout.ring_tilt_slot() + k];
  return k == 0 ? m.misalignment_y : m.misalignment_z;
}

double cage_stress(const Instant& at) {
  if (!at.stress) return std::numeric_limits<double>::quiet_NaN();
  const Observation& seen = at.system.seen;
  return kMPa *
         at.stress->largest(border(at) + kModes, seen.bar_force, seen.centrifugal_spin).stress;
}

double skew(const Instant& at, int j) {
  const double angle = roller_position(at, kAngle, j);
  return std::cos(angle) * roller_position(at, kAxisZ, j) -
         std::sin(angle) * roller_position(at, kAxisY, j);
}
double tilt(const Instant& at, int j) {
  const double angle = roller_position(at, kAngle, j);
  return std::cos(angle) * roller_position(at, kAxisY, j) +
         std::sin(angle) * roller_position(at, kAxisZ, j);
}

double of_roller(const PackVector& values, int roller) {
  return values[static_cast<std::size_t>(roller)];
}

}  // namespace

// clang-format off
const std::vector<BearingChannel>& bearing_channels() {
  using I = const Instant&;
  static const std::vector<BearingChannel> channels = {
      {"ring_y", "um", "inner ring, y", [](I at) { return kUm * border(at)[kRingY]; }},
      {"ring_z", "um", "inner ring, z (the load acts along -z)", [](I at) { return kUm * border(at)[kRingZ]; }},
      {"ring_displacement", "um", "inner ring, along the load", [](I at) { return -kUm * border(at)[kRingZ]; }},
      {"ring_velocity", "m/s", "speed of the inner ring's centre", ring_speed},
      {"ring_acceleration", "m/s2", "acceleration of the inner ring's centre, magnitude", ring_acceleration},
      {"ring_tilt_y", "mrad", "slope of the inner ring's centre line in y", [](I at) { return kMrad * ring_tilt(at, 0); }},
      {"ring_tilt_z", "mrad", "slope of the inner ring's centre line in z", [](I at) { return kMrad * ring_tilt(at, 1); }},
      {"cage_x", "um", "cage centre, axial", [](I at) { return kUm * border(at)[kCageX]; }},
      {"cage_y", "um", "geometric centre of the cage, y", [](I at) { return kUm * cage_centre(at).y; }},
      {"cage_z", "um", "geometric centre of the cage, z", [](I at) { return kUm * cage_centre(at).z; }},
      {"cage_velocity", "m/s", "speed of the cage's geometric centre in the radial plane", cage_centre_speed},
      {"cage_speed", "rpm", "rotational speed of the cage", [](I at) { return border_speed(at)[kCagePhi] / kRpm; }},
      {"cage_stress", "MPa", "largest von Mises stress in the cage; NaN for a rigid cage", cage_stress},
      {"guide_force", "N", "normal force between the cage's lands and the guiding ring", [](I at) { return at.system.seen.land_force[0] + at.system.seen.land_force[1]; }},
  };
  return channels;
}

const std::vector<RollerChannel>& roller_channels() {
  using I = const Instant&;
  static const std::vector<RollerChannel> channels = {
      {"roller_spin", "rpm", "absolute spin of a roller about its own axis", [](I at, int j) { return roller_velocity(at, kSpin, j) / kRpm; }},
      {"roller_orbit_speed", "rpm", "speed of a roller about the bearing axis", [](I at, int j) { return roller_velocity(at, kOrbitRate, j) / kRpm; }},
      {"roller_skew", "mrad", "skew of a roller, a . e_t", [](I at, int j) { return kMrad * skew(at, j); }},
      {"roller_tilt", "mrad", "tilt of a roller, a . e_r", [](I at, int j) { return kMrad * tilt(at, j); }},
      {"inner_force", "N", "normal force on the inner raceway", [](I at, int j) { return of_roller(at.system.seen.inner_force, j); }},
      {"outer_force", "N", "normal force on the outer raceway", [](I at, int j) { return of_roller(at.system.seen.outer_force, j); }},
      {"leading_force", "N", "normal force on the pocket's bar ahead of the roller", [](I at, int j) { return of_roller(at.system.seen.leading_force, j); }},
      {"trailing_force", "N", "normal force on the pocket's bar behind the roller", [](I at, int j) { return of_roller(at.system.seen.trailing_force, j); }},
      {"end_force", "N", "normal force on both side ring faces of the pocket", [](I at, int j) { return of_roller(at.system.seen.wall_force, j); }},
      {"flange_force", "N", "normal force on the ring's flanges", [](I at, int j) { return of_roller(at.system.seen.flange_force, j); }},
  };
  return channels;
}
// clang-format on

}  // namespace cagetol
