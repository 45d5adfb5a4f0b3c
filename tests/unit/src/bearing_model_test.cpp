// Kinematics of the NU 205 at 6000 rpm without clearance (the model, the start state and the forces
// at it), and jams.
#include "src/model/bearing_model.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "src/integration/system.hpp"
#include "src/scene/pocket_outline.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kRpm = 2 * std::numbers::pi / 60;

Scene tight_nu205() {
  Scene scene;
  scene.bearing.internal_clearance = 0;
  scene.operation.gravity = 0;
  return scene;
}

TEST(BearingModel, KinematicsOfNu205) {
  const Scene scene = tight_nu205();
  const BearingModel model = make_bearing_model(scene);
  EXPECT_NEAR(kinematic_cage_speed(model, {scene.operation.inner_speed, 0}) / kRpm, 2423.08, 0.005);
  const std::vector<double> y = start_state(model, scene.start);
  for (int j = 0; j < model.layout.rollers; ++j) {
    const double spin = y[static_cast<std::size_t>(model.layout.velocity(kSpin, j))];
    const double orbit = y[static_cast<std::size_t>(model.layout.velocity(kOrbitRate, j))];
    EXPECT_NEAR(spin / kRpm, -12600.0, 0.05);
    EXPECT_NEAR((orbit - spin) / kRpm, 15023.1, 0.05);
  }
  EXPECT_NEAR(y[static_cast<std::size_t>(model.layout.border_velocity(kCagePhi))] / kRpm, 2423.08,
              0.005);
}

TEST(BearingModel, UnloadedRollersRestOnTheOuterRaceByCentrifugalForce) {
  const Scene scene = tight_nu205();
  const BearingModel model = make_bearing_model(scene);
  const std::vector<double> y = start_state(model, scene.start);
  System system(model);
  ASSERT_TRUE(system.linearise_at(0, y.data()));
  int unloaded = 0;
  for (int j = 0; j < model.layout.rollers; ++j) {
    const auto k = static_cast<std::size_t>(j);
    if (system.seen.inner_force[k] > 0) continue;
    ++unloaded;
    EXPECT_NEAR(system.seen.outer_force[k], 3.899, 0.001);
    const double orbit = 2423.077 * kRpm,
                 r = y[static_cast<std::size_t>(model.layout.position(kRadius, j))];
    EXPECT_NEAR(system.seen.outer_force[k], model.groups[0].mass[0] * r * orbit * orbit, 1e-5);
  }
  EXPECT_GE(unloaded, 5);
}

TEST(BearingModel, StartIsInBalance) {
  for (const double clearance : {0.0, 30e-6}) {
    Scene scene;
    scene.bearing.internal_clearance = clearance;
    scene.bearing.misalignment_z = 0.3e-3;
    scene.roller.profile = RollerProfile::logarithmic;
    const BearingModel model = make_bearing_model(scene);
    const std::vector<double> y = start_state(model, scene.start);
    System system(model);
    ASSERT_TRUE(system.linearise_at(0, y.data()));
    const auto rate = [&](int slot) { return system.rate[static_cast<std::size_t>(slot)]; };
    // Friction of pure rolling is small, not zero: compare with the load over the mass.
    const double unit = scene.operation.radial_load / model.ring_mass;
    EXPECT_LT(std::abs(rate(model.layout.border_velocity(kRingY))), 0.02 * unit);
    EXPECT_LT(std::abs(rate(model.layout.border_velocity(kRingZ))), 0.02 * unit);
    EXPECT_NEAR(system.seen.ring_elastic_z, 1000 + model.ring_mass * 9.81, 1e-5);
    EXPECT_NEAR(system.seen.ring_elastic_y, 0, 1e-5);
  }
}

TEST(BearingModel, RampsFollowStep) {
  Scene scene;
  scene.operation.tilting_moment_y = 4;
  scene.operation.tilting_moment_z = -6;
  scene.operation.load_ramp = 1e-3;
  scene.operation.speed_ramp = 2e-3;
  scene.operation.speed_ramp_from = 100;
  const BearingModel m = make_bearing_model(scene);
  EXPECT_EQ(load_at(m.duty, 0).z, 0);
  EXPECT_DOUBLE_EQ(-load_at(m.duty, 0.5e-3).z, 500);
  EXPECT_DOUBLE_EQ(load_at(m.duty, 0.5e-3).moment_y, 2);
  EXPECT_DOUBLE_EQ(load_at(m.duty, 0.5e-3).moment_z, -3);
  EXPECT_DOUBLE_EQ(-load_at(m.duty, 1).z, 1000);
  EXPECT_EQ(ring_speeds_at(m.duty, 0).inner, 100);
  EXPECT_DOUBLE_EQ(ring_speeds_at(m.duty, 1e-3).inner, (100 + scene.operation.inner_speed) / 2);
  EXPECT_DOUBLE_EQ(ring_speeds_at(m.duty, 1).inner, scene.operation.inner_speed);
}

TEST(FindJam, NamesTheWorstPocketAndItsInterference) {
  Scene scene;
  EXPECT_EQ(find_jam(scene).pocket, -1);
  scene.cage.pocket_width.assign(13, 7.65e-3);
  scene.cage.pocket_length.assign(13, 9.25e-3);
  scene.cage.pocket_width[4] = 7.49e-3;
  scene.cage.pocket_width[9] = 7.47e-3;
  Jam jam = find_jam(scene);
  EXPECT_EQ(jam.pocket, 9);
  EXPECT_STREQ(jam.where, "width");
  EXPECT_NEAR(jam.interference, 30e-6, 1e-12);
  scene.cage.pocket_length[2] = 8.9e-3;
  jam = find_jam(scene);
  EXPECT_EQ(jam.pocket, 2);
  EXPECT_STREQ(jam.where, "length");
  EXPECT_NEAR(jam.interference, 100e-6, 1e-12);
  // No clearance at all is a jam already.
  Scene exact;
  exact.cage.pocket_width = {7.5e-3};
  EXPECT_EQ(find_jam(exact).pocket, 0);
}

TEST(FindJam, LipsThatPinchTheRollerAreAJam) {
  Scene scene;
  const auto lips = [&](double play) {
    return retention_width(scene.cage, pitch_radius(scene.bearing), 3.75e-3, 1, play);
  };
  const double loose = lips(20e-6), tight = lips(-30e-6);
  scene.cage.retention_outer = {loose};
  EXPECT_EQ(find_jam(scene).pocket, -1);
  scene.cage.retention_outer = {tight};
  const Jam jam = find_jam(scene);
  EXPECT_EQ(jam.pocket, 0);
  EXPECT_STREQ(jam.where, "lips at the outside");
  EXPECT_NEAR(jam.interference, 30e-6, 1e-9);
}

// 2 g mm on a cage of 20 g: 0.1 mm, towards 30 degrees from pocket 0.
TEST(BearingModel, AnUnbalanceOfTheCageMovesItsMassCentre) {
  Scene scene;
  scene.cage.mass = 20e-3;
  scene.cage.unbalance = 2e-6;
  scene.cage.unbalance_phase = std::numbers::pi / 6;
  const BearingModel m = make_bearing_model(scene);
  EXPECT_NEAR(m.unbalance_y, 0.1e-3 * std::cos(std::numbers::pi / 6), 1e-12);
  EXPECT_NEAR(m.unbalance_z, 0.05e-3, 1e-12);
}

}  // namespace
}  // namespace cagetol
