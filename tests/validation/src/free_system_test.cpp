// Rollers and cage flying free, touching one another but no ring: what must be kept is kept,
// whatever the angle origin.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "src/integration/integrator.hpp"
#include "src/quantities/observer.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

Scene free_scene() {
  Scene scene;
  scene.bearing.internal_clearance = 4e-3;  // the races are 1 mm away
  scene.bearing.flange_clearance = 4e-3;
  scene.cage.guidance = Guidance::roller;
  scene.operation = {.radial_load = 0, .inner_speed = 0, .gravity = 0};
  scene.integration.tolerance = 5e-8;
  return scene;
}

/// Cage turning, rollers lagging behind at different speeds, spinning; `lean` scales every motion
/// out of the radial plane.
std::vector<double> free_start(const BearingModel& model, double lean, double turned) {
  const StateLayout& l = model.layout;
  std::mt19937_64 engine(11);
  const auto about = [&](double size) {
    return size * (static_cast<double>(engine() >> 11) * 0x1p-52 - 1);
  };
  std::vector<double> y(static_cast<std::size_t>(l.size()), 0.0);
  const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
  const double c = std::cos(turned), s = std::sin(turned);
  for (int j = 0; j < l.padded(); ++j) {
    at(l.position(kRadius, j)) = model.pitch_radius;
    at(l.position(kAngle, j)) = 2 * pi * j / l.rollers + turned;
    if (j >= l.rollers) continue;
    at(l.velocity(kOrbitRate, j)) = 30 + about(10);
    at(l.velocity(kSpin, j)) = about(200);
    at(l.velocity(kAxialSpeed, j)) = lean * about(0.1);
    const double a = lean * about(1e-3), b = lean * about(1e-3), u = lean * about(0.5),
                 v = lean * about(0.5);
    at(l.position(kAxisY, j)) = c * a - s * b;
    at(l.position(kAxisZ, j)) = s * a + c * b;
    at(l.velocity(kAxisRateY, j)) = c * u - s * v;
    at(l.velocity(kAxisRateZ, j)) = s * u + c * v;
  }
  at(l.border_position(kCagePhi)) = turned;
  at(l.border_velocity(kCagePhi)) = 60;
  const double vy = 0.05, vz = -0.03;
  at(l.border_velocity(kCageY)) = c * vy - s * vz;
  at(l.border_velocity(kCageZ)) = s * vy + c * vz;
  return y;
}

struct Momenta {
  double y = 0, z = 0, x = 0, spin = 0;  ///< linear, and angular about the bearing axis
  double linear_size = 0, angular_size = 0;
};

/// Angular momentum of a body about its own centre along x: its spin, and the share of the lean,
/// second order in the angles.
double spun(double polar, double transverse, double spin, double a_y, double a_z, double b_y,
            double b_z) {
  return polar * spin * (1 - (a_y * a_y + a_z * a_z) / 2) + transverse * (a_y * b_z - a_z * b_y);
}

Momenta momenta(const BearingModel& m, const std::vector<double>& y) {
  const StateLayout& l = m.layout;
  const auto at = [&](int slot) { return y[static_cast<std::size_t>(slot)]; };
  Momenta p;
  const auto add = [&](double mass, double py, double pz, double vx, double vy, double vz,
                       double own) {
    p.x += mass * vx;
    p.y += mass * vy;
    p.z += mass * vz;
    p.spin += mass * (py * vz - pz * vy) + own;
    p.linear_size += mass * std::hypot(vx, vy, vz);
    p.angular_size += mass * std::abs(py * vz - pz * vy) + std::abs(own);
  };
  for (int j = 0; j < l.rollers; ++j) {
    const RollerGroup& g = m.groups[static_cast<std::size_t>(j / kLanes)];
    const double r = at(l.position(kRadius, j)), a = at(l.position(kAngle, j));
    const double vr = at(l.velocity(kRadialSpeed, j)), vt = r * at(l.velocity(kOrbitRate, j));
    add(g.mass[j % kLanes], r * std::cos(a), r * std::sin(a), at(l.velocity(kAxialSpeed, j)),
        vr * std::cos(a) - vt * std::sin(a), vr * std::sin(a) + vt * std::cos(a),
        spun(g.polar[j % kLanes], g.transverse[j % kLanes], at(l.velocity(kSpin, j)),
             at(l.position(kAxisY, j)), at(l.position(kAxisZ, j)), at(l.velocity(kAxisRateY, j)),
             at(l.velocity(kAxisRateZ, j))));
  }
  const auto q = [&](int slot) { return at(l.border_position(slot)); };
  const auto v = [&](int slot) { return at(l.border_velocity(slot)); };
  add(m.cage_mass, q(kCageY), q(kCageZ), v(kCageX), v(kCageY), v(kCageZ),
      spun(m.cage_polar, m.cage_transverse, v(kCagePhi), q(kCageAxisY), q(kCageAxisZ),
           v(kCageAxisY), v(kCageAxisZ)));
  return p;
}

struct Flight {
  std::vector<double> end;
  double energy_residual = 0;
  double dissipated = 0;
  double pocket_peak = 0;
};

Flight fly(const BearingModel& model, const Scene& scene, std::vector<double> y, double end) {
  System system(model);
  Observer observer(model, 0, end);
  double t = 0;
  Flight flight;
  const auto integrator = make_integrator(scene.integration, system, t, y.data());
  for (;;) {
    EXPECT_TRUE(system.linearise_at(t, y.data()));
    observer.record(t, y.data(), system);
    for (int j = 0; j < model.layout.rollers; ++j) {
      const auto k = static_cast<std::size_t>(j);
      EXPECT_EQ(
          system.seen.inner_force[k] + system.seen.outer_force[k] + system.seen.flange_force[k], 0);
      flight.pocket_peak = std::max(
          {flight.pocket_peak, system.seen.leading_force[k], system.seen.trailing_force[k]});
    }
    if (t >= end) break;
    if (integrator->step(system, t, y.data(), end) != StepStatus::accepted) {
      ADD_FAILURE() << integrator->failure();
      break;
    }
  }
  flight.end = y;
  flight.energy_residual = observer.energy_residual();
  return flight;
}

void expect_kept(const Scene& scene, double lean, double linear) {
  const BearingModel model = make_bearing_model(scene);
  const std::vector<double> start = free_start(model, lean, 0);
  const Flight flight = fly(model, scene, start, 2e-3);
  EXPECT_GT(flight.pocket_peak, 1);  // they do meet
  const Momenta before = momenta(model, start), after = momenta(model, flight.end);
  EXPECT_NEAR(after.x, before.x, 1e-6 * before.linear_size);
  EXPECT_NEAR(after.y, before.y, linear * before.linear_size);
  EXPECT_NEAR(after.z, before.z, linear * before.linear_size);
  EXPECT_NEAR(after.spin, before.spin, 1e-6 * before.angular_size);
  EXPECT_LT(flight.energy_residual, 1e-6);
}

TEST(FreeSystem, KeepsMomentumAndClosesItsEnergyAccountInThePlane) {
  expect_kept(free_scene(), 0, 1e-6);
}

TEST(FreeSystem, KeepsThemWithLeaningRollersToo) {
  Scene scene = free_scene();
  scene.cage.pocket_length = {11e-3};  // the side ring faces are out of reach
  expect_kept(scene, 1, 1e-6);
}

TEST(FreeSystem, KeepsThemAtTheEndWallsToo) {
  expect_kept(free_scene(), 1, 1e-6);
}

TEST(FreeSystem, TurningTheStartTurnsTheResult) {
  const Scene scene = free_scene();
  const BearingModel model = make_bearing_model(scene);
  const StateLayout& l = model.layout;
  const double end = 1e-3, angle = 1.234;
  const std::vector<double> plain = fly(model, scene, free_start(model, 1, 0), end).end;
  const std::vector<double> turned = fly(model, scene, free_start(model, 1, angle), end).end;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto expect_turned = [&](int y_slot, int z_slot, double tolerance) {
    const double y = plain[static_cast<std::size_t>(y_slot)],
                 z = plain[static_cast<std::size_t>(z_slot)];
    EXPECT_NEAR(turned[static_cast<std::size_t>(y_slot)], c * y - s * z, tolerance);
    EXPECT_NEAR(turned[static_cast<std::size_t>(z_slot)], s * y + c * z, tolerance);
  };
  const auto expect_shifted = [&](int slot, double shift, double tolerance) {
    EXPECT_NEAR(turned[static_cast<std::size_t>(slot)],
                plain[static_cast<std::size_t>(slot)] + shift, tolerance);
  };
  // Impacts magnify the rounding in which the two differ.
  const double place = 2e-8, speed = 2e-4, lever = 5e-3;
  for (int j = 0; j < l.rollers; ++j) {
    expect_shifted(l.position(kRadius, j), 0, place);
    expect_shifted(l.position(kAngle, j), angle, place / lever);
    expect_shifted(l.position(kAxial, j), 0, place);
    expect_turned(l.position(kAxisY, j), l.position(kAxisZ, j), place / lever);
    expect_shifted(l.velocity(kRadialSpeed, j), 0, speed);
    expect_shifted(l.velocity(kSpin, j), 0, speed / lever);
  }
  expect_turned(l.border_position(kCageY), l.border_position(kCageZ), place);
  expect_turned(l.border_velocity(kCageY), l.border_velocity(kCageZ), speed);
  expect_turned(l.border_position(kCageAxisY), l.border_position(kCageAxisZ), place / lever);
  expect_shifted(l.border_position(kCagePhi), angle, place / lever);
  expect_shifted(l.border_velocity(kCagePhi), 0, speed / lever);
}

}  // namespace
}  // namespace cagetol
