// The periodic motion of a roller holds the equations of motion of the whole bearing, computed by
// forces.hpp at the same places and speeds.
#include "src/statics/roller_orbit.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "src/dynamics/forces.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr int kRollers = 8;  // whose angles are those of a turn, at as many phases

Scene orbit_scene(double load, double rpm) {
  Scene scene = shipped_scene("nu205");
  scene.lubrication.model = LubricationModel::film;
  scene.lubrication.viscosity = 0.02;
  scene.lubrication.land_film = false;  // the orbit is the rollers', and so is its torque
  scene.lubrication.churning = false;
  scene.bearing.misalignment_z = 0;
  scene.bearing.roller_count = kRollers;
  scene.operation.radial_load = load;
  scene.operation.inner_speed = rpm * 2 * std::numbers::pi / 60;
  return scene;
}

/// The bearing as it stands where roller 0 is at angle number `phase`, and its rates there.
struct Snapshot {
  BearingModel model;
  std::vector<double> y, rate;

  Snapshot(const BearingModel& from, const OrbitTurn& turn, std::size_t phase) : model(from) {
    const StateLayout& l = model.layout;
    y.assign(static_cast<std::size_t>(l.size()), 0.0);
    rate = y;
    const std::size_t angles = turn.radius.size();
    for (int j = 0; j < l.padded(); ++j) {
      const std::size_t k = (phase + static_cast<std::size_t>(j) * (angles / kRollers)) % angles;
      const double angle =
          2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(angles);
      const double pocket = angle - std::asin(turn.offset[k] / turn.radius[k]);
      RollerGroup& g = model.groups[static_cast<std::size_t>(j / kLanes)];
      g.pocket_cos[j % kLanes] = std::cos(pocket);
      g.pocket_sin[j % kLanes] = std::sin(pocket);
      at(l.position(kRadius, j)) = turn.radius[k];
      at(l.position(kAngle, j)) = angle;
      at(l.velocity(kOrbitRate, j)) = turn.cage_speed;
      at(l.velocity(kSpin, j)) = turn.spin[k];
    }
    at(l.border_position(kRingY)) = turn.ring_y;
    at(l.border_position(kRingZ)) = turn.ring_z;
    at(l.border_velocity(kCagePhi)) = turn.cage_speed;
    evaluate_rates(model, 0, y.data(), rate.data());
  }
  double& at(int slot) { return y[static_cast<std::size_t>(slot)]; }
  double rate_of(int slot) const { return rate[static_cast<std::size_t>(slot)]; }
};

class OrbitOfRollers : public testing::TestWithParam<std::tuple<double, double, double>> {};

TEST_P(OrbitOfRollers, HoldsTheEquationsOfMotionOfTheBearing) {
  const auto [load, rpm, share] = GetParam();
  const BearingModel model = make_bearing_model(orbit_scene(load, rpm));
  const double w = share * kinematic_cage_speed(model, model.duty.speed);
  RollerOrbit orbit(model);
  ASSERT_TRUE(orbit.solve(w));
  const OrbitTurn& turn = orbit.turn();
  const StateLayout& l = model.layout;
  const std::size_t angles = turn.radius.size(), phases = angles / kRollers;
  const double mass = model.groups[0].mass[0], polar = model.groups[0].polar[0],
               radius = model.groups[0].radius[0];
  const double rolling = std::abs(model.duty.speed.inner) * model.inner_radius / (2 * radius);
  double torque = 0, force_y = 0, force_z = 0, ring_y = 0, ring_z = 0, moments = 0, spins = 0;
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const Snapshot now(model, turn, phase);
    const double per = 1.0 / static_cast<double>(phases);
    torque += per * model.cage_polar * now.rate_of(l.border_velocity(kCagePhi));
    force_y += per * model.cage_mass * now.rate_of(l.border_velocity(kCageY));
    force_z += per * model.cage_mass * (now.rate_of(l.border_velocity(kCageZ)) + model.gravity);
    ring_y += per * model.ring_mass * now.rate_of(l.border_velocity(kRingY));
    ring_z += per * model.ring_mass * now.rate_of(l.border_velocity(kRingZ));
    for (int j = 0; j < kRollers; ++j) {
      const std::size_t k = (phase + static_cast<std::size_t>(j) * phases) % angles,
                        before = (k + (w < 0 ? 1 : angles - 1)) % angles;
      const double weight = std::max(mass * model.pitch_radius * w * w, 0.1);
      EXPECT_LT(mass * std::abs(now.rate_of(l.velocity(kRadialSpeed, j))),
                0.02 * weight + 1e-3 * load)
          << k;
      EXPECT_LT(mass * model.pitch_radius * std::abs(now.rate_of(l.velocity(kOrbitRate, j))),
                5e-3 * weight)
          << k;
      const double step = 2 * std::numbers::pi / static_cast<double>(angles) / std::abs(w);
      const double change = polar * (turn.spin[k] - turn.spin[before]) / step,
                   moment = polar * now.rate_of(l.velocity(kSpin, j));
      spins += std::abs(change - moment) / static_cast<double>(angles);
      moments += polar * rolling / step / static_cast<double>(angles);
    }
  }
  EXPECT_LT(spins, 1e-3 * moments);
  EXPECT_NEAR(turn.torque, torque, 1e-4 * std::abs(torque));
  EXPECT_NEAR(turn.force_y, force_y, 1e-3 * std::abs(force_y));
  EXPECT_NEAR(turn.force_z, force_z, 1e-3 * std::abs(force_y));
  // The ring bears its load; what traction does to it is left out.
  const double most = 0.07 * load + 1;
  EXPECT_NEAR(ring_y, 0, most);
  EXPECT_NEAR(ring_z, 0, most);
}

INSTANTIATE_TEST_SUITE_P(FromSlipToRolling, OrbitOfRollers,
                         testing::Values(std::tuple{50.0, 6000.0, 0.5},
                                         std::tuple{200.0, 6000.0, 0.95},
                                         std::tuple{1000.0, 6000.0, 0.999},
                                         std::tuple{300.0, -6000.0, 0.8},
                                         std::tuple{1000.0, 20000.0, 0.9}));

TEST(RollerOrbit, MirrorsWithTheDirectionOfTurning) {
  RollerOrbit ahead(make_bearing_model(orbit_scene(200, 6000))),
      back(make_bearing_model(orbit_scene(200, -6000)));
  ASSERT_TRUE(ahead.solve(240));
  ASSERT_TRUE(back.solve(-240));
  const OrbitTurn &a = ahead.turn(), &b = back.turn();
  EXPECT_NEAR(a.torque, -b.torque, 1e-3 * std::abs(a.torque));
  EXPECT_NEAR(a.force_y, -b.force_y, 1e-3 * std::abs(a.force_y));
  const std::size_t n = a.radius.size();
  for (std::size_t k = 0; k < n; ++k) {  // across the vertical line
    const std::size_t mirrored = (n + n / 2 - k) % n;
    EXPECT_NEAR(a.spin[k], -b.spin[mirrored], 1e-3 * std::abs(a.spin[0]));
    EXPECT_NEAR(a.radius[k], b.radius[mirrored], 1e-8);
  }
}

}  // namespace
}  // namespace cagetol
