#include "src/quasi_static.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <ctime>
#include <numbers>

#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "src/statics/static_equilibrium.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

Scene quasi_static(Scene scene) {
  scene.model.motion = MotionModel::quasi_static;
  return scene;
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// ISO/TS 16281 line stiffness, l = 10 mm, F = 1000 N, a roller under the load at standstill; see
// static_equilibrium_test.cpp.
TEST(QuasiStatic, StandstillGivesTheClosedDisplacement) {
  Scene scene;
  scene.bearing.roller_count = 14;
  scene.bearing.inner_raceway_diameter = 1.991;
  scene.bearing.outer_raceway_diameter = 2.009;
  scene.bearing.shoulder_diameter = 2.006;
  scene.bearing.internal_clearance = 20e-6;
  scene.roller.diameter = {9e-3};
  scene.roller.length = 10e-3;
  scene.operation.gravity = 0;
  scene.operation.inner_speed = 0;
  scene.cage.pocket_width = {9.2e-3};
  scene.cage.pocket_length = {10.2e-3};
  scene.start.cage_phase = -pi / 2;
  scene.window.settle_time = 0;
  scene.window.measure_time = 1;
  const Outcome outcome = simulate(quasi_static(scene));
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_EQ(outcome.run.steps, 1);
  EXPECT_NEAR(quantity(outcome, "ring_displacement_end_um"), 13.336, 1e-3);
  EXPECT_EQ(quantity(outcome, "ring_displacement_mean_um"),
            quantity(outcome, "ring_displacement_end_um"));
  EXPECT_EQ(quantity(outcome, "ring_orbit_p95_um"), 0);
}

TEST(QuasiStatic, MeanIsThatOfManyMorePositions) {
  Scene scene = dry_scene("nu205");
  scene.roller.diameter.assign(13, 7.5e-3);
  scene.roller.diameter[4] += 3e-6;  // the pitch does not repeat, the turn does
  const Outcome outcome = simulate(quasi_static(scene));
  const BearingModel model = make_bearing_model(scene);
  const double speed = kinematic_cage_speed(model, model.duty.speed);
  StaticEquilibrium equilibrium(model);
  constexpr int kMany = 13 * 200;
  double sum = 0;
  for (int k = 0; k < kMany; ++k)
    sum -= equilibrium
               .solve(roller_angles(model, 2 * pi * k / kMany).data(), speed, model.duty.fixed,
                      RollerMotion::orbiting)
               .ring_z;
  const double mean = quantity(outcome, "ring_displacement_mean_um");
  RecordProperty("relative", std::to_string(1e9 * (mean / (1e6 * sum / kMany) - 1)));
  EXPECT_NEAR(mean / (1e6 * sum / kMany), 1, 5e-5);
  EXPECT_EQ(outcome.run.steps, 13 * 8);
  EXPECT_NEAR(outcome.run.cage_revolutions, 1, 1e-12);
}

TEST(QuasiStatic, DefinesWhatEquilibriaDefineAndNothingElse) {
  const Scene scene = quasi_static(dry_scene("nu205"));
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  for (std::size_t k = 0; k < quantity_table().size(); ++k) {
    const std::string key = quantity_table()[k].key;
    EXPECT_EQ(!std::isnan(outcome.quantities[k]), quantity_table()[k].need.met(scene)) << key;
  }
}

TEST(QuasiStatic, WindowShorterThanATurnIsCoveredToItsEnd) {
  Scene scene = quasi_static(dry_scene("nu205"));
  scene.window.settle_revolutions = 0.25;
  scene.window.measure_revolutions = 0.5;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.run.steps, 13 * 4);
  const BearingModel model = make_bearing_model(scene);
  StaticEquilibrium equilibrium(model);
  const StaticState& end = equilibrium.solve(
      roller_angles(model, scene.start.cage_phase + 1.5 * pi).data(),
      kinematic_cage_speed(model, model.duty.speed), model.duty.fixed, RollerMotion::orbiting);
  EXPECT_NEAR(quantity(outcome, "ring_displacement_end_um"), -1e6 * end.ring_z, 1e-6);
}

TEST(QuasiStatic, JamsLikeEveryRun) {
  Scene scene = quasi_static(dry_scene("nu205"));
  scene.cage.pocket_width = {7.49e-3};
  EXPECT_EQ(simulate(scene).status, Status::jammed);
}

// Measured near 1/50 (1/150 before the motion became cheaper). A clock, which other work and other
// processors disturb, decides on an order of magnitude only; counts decide on the rest.
TEST(QuasiStatic, CostsFarLessThanTheMotion) {
  const Scene scene = dry_scene("nu205");
  Scene part = scene;  // an eighth of the default motion
  part.window.settle_revolutions = 0;
  part.window.measure_revolutions =
      (scene.window.settle_revolutions + scene.window.measure_revolutions) / 8;
  part.watch.static_consistency_max = 1;
  double began = cpu_seconds();
  const Outcome moved = simulate(part);
  const double motion = 8 * (cpu_seconds() - began);
  ASSERT_EQ(moved.status, Status::ok);
  double equilibria = 1e30;
  for (int k = 0; k < 5; ++k) {
    began = cpu_seconds();
    const Outcome rested = simulate(quasi_static(scene));
    equilibria = std::min(equilibria, cpu_seconds() - began);
    ASSERT_EQ(rested.status, Status::ok);
    EXPECT_EQ(rested.run.steps, 8 * 13);  // positions: 8 a pitch, over a turn
    EXPECT_LT(100 * rested.run.steps, 8 * moved.run.steps);
  }
  RecordProperty("ratio", std::to_string(motion / equilibria));
  EXPECT_LT(equilibria, motion / 5);
}

}  // namespace
}  // namespace cagetol
