// Both rings, loads of any direction: what symmetry and rigid motion demand of whole runs.
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "src/integration/system.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kPerRpm = pi / 30;

/// Rollers mirror each other at y = 0, and nothing but the load acts.
Scene symmetric_scene() {
  Scene scene = shipped_scene("nu205");
  scene.cage.model = CageKind::rigid;
  scene.operation.gravity = 0;
  scene.start.cage_phase = pi / 2;
  scene.start.state = StartState::equilibrium;  // the steady one is found to 1e-5 of the speed
  scene.integration.tolerance = 1e-4;
  scene.window = {};
  scene.window.settle_time = 0.2e-3;
  scene.window.measure_time = 0.6e-3;
  return scene;
}

// Seen in a mirror at y = 0 a bearing turns the other way round. Both runs round differently.
TEST(Operation, ReversedSpeedsMirrorTheMotion) {
  for (const bool outer_too : {false, true}) {
    Scene scene = symmetric_scene();
    scene.operation.outer_speed = outer_too ? -1500 * kPerRpm : 0;
    const Outcome there = simulate(scene);
    scene.operation.inner_speed *= -1;
    scene.operation.outer_speed *= -1;
    const Outcome back = simulate(scene);
    for (const char* key :
         {"cage_slip_ratio", "driving_slip_ratio", "roller_slip_ratio_loaded", "power_loss_W",
          "whirl_radius_ratio_mean", "ring_displacement_mean_um", "guide_force_rms_N"}) {
      const double value = quantity(there, key);
      EXPECT_NEAR(quantity(back, key), value, 1e-4 * std::abs(value)) << key << ", " << outer_too;
    }
    const double torque = quantity(there, "friction_torque_Nmm");
    EXPECT_GT(torque, 1);
    EXPECT_NEAR(quantity(back, "friction_torque_Nmm"), -torque, 1e-4 * torque) << outer_too;
  }
}

// Everything turns as one body: each roller is pressed on the outer race with m r w^2.
TEST(Operation, RingsThatTurnAlikeMoveNothing) {
  for (const LubricationModel oil : {LubricationModel::none, LubricationModel::film}) {
    Scene scene = symmetric_scene();
    scene.lubrication.model = oil;
    scene.lubrication.churning = false;  // the fluid would turn slower than all else
    scene.operation.radial_load = 0;
    scene.operation.inner_speed = scene.operation.outer_speed = 3000 * kPerRpm;
    scene.window.measure_time = 4e-3;
    const Outcome outcome = simulate(scene);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
    const BearingModel model = make_bearing_model(scene);
    const double spin = 3000 * kPerRpm, mass = model.groups.front().mass[0];
    EXPECT_NEAR(quantity(outcome, "cage_slip_ratio"), 0, 1e-3);
    EXPECT_EQ(quantity(outcome, "friction_torque_Nmm"), 0);
    // Against what the same rollers lose between rings that turn apart.
    EXPECT_LT(std::abs(quantity(outcome, "power_loss_W")), 0.02);
    std::vector<double> start = start_state(model, scene.start);
    System system(model);
    PackVector y(start.begin(), start.end());
    ASSERT_TRUE(system.linearise_at(0, y.data()));
    // A start without slip at either race lets rollers spin faster by the clearance's share.
    const double within = 3e-3;
    for (int j = 0; j < model.layout.rollers; ++j) {
      const double r = y[static_cast<std::size_t>(model.layout.position(kRadius, j))];
      EXPECT_NEAR(system.seen.outer_force[static_cast<std::size_t>(j)], mass * r * spin * spin,
                  within * mass * r * spin * spin);
      EXPECT_NEAR(y[static_cast<std::size_t>(model.layout.velocity(kSpin, j))], spin,
                  within * spin);
    }
  }
}

// Dry, the cage follows its rollers, and these roll.
TEST(Operation, AnOuterRingAloneDrivesTheCageAtItsRollingSpeed) {
  Scene scene = symmetric_scene();
  scene.lubrication.model = LubricationModel::none;
  scene.start.state = StartState::equilibrium;
  scene.operation.inner_speed = 0;
  scene.operation.outer_speed = 4000 * kPerRpm;
  scene.window = {};
  scene.window.settle_revolutions = 0.5;
  scene.window.measure_revolutions = 1;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  const BearingModel m = make_bearing_model(scene);
  const double due =
      scene.operation.outer_speed * m.outer_radius / (m.inner_radius + m.outer_radius);
  EXPECT_DOUBLE_EQ(kinematic_cage_speed(m, m.duty.speed), due);
  EXPECT_NEAR(quantity(outcome, "driving_slip_ratio"), 0, 3e-3);
  EXPECT_NEAR(quantity(outcome, "cage_slip_ratio"), 0, 5e-3);
}

// What the outer ring loses it is driven with.
TEST(Operation, TheAccountOfEnergyClosesWithBothRingsTurning) {
  Scene scene = symmetric_scene();
  scene.operation.outer_speed = -2000 * kPerRpm;
  scene.operation.rotating_load = 300;
  scene.operation.unbalance = 1e-4;
  scene.operation.shaft_inclination = pi / 3;
  scene.operation.gravity = 9.81;
  scene.window.measure_time = 5e-3;
  const Outcome outcome = simulate(scene);
  EXPECT_LT(outcome.run.energy_residual, 0.01) << outcome.reason;
}

// The same bearing, seen turned by the angle of its load, or from a frame that turns with it.
TEST(Operation, AQuasiStaticBearingDoesNotCareWhereItsLoadPoints) {
  Scene scene = shipped_scene("nu205");
  scene.model.motion = MotionModel::quasi_static;
  scene.cage.model = CageKind::rigid;
  scene.operation.gravity = 0;
  scene.bearing.misalignment_y = scene.bearing.misalignment_z = 0;  // it has a direction
  const double fixed = quantity(simulate(scene), "ring_displacement_mean_um");
  scene.operation.load_direction = 2 * pi / 13 * 4;
  EXPECT_NEAR(quantity(simulate(scene), "ring_displacement_mean_um"), fixed, 1e-6 * fixed);
  scene.operation.load_direction = 1.234;
  EXPECT_NEAR(quantity(simulate(scene), "ring_displacement_mean_um"), fixed, 1e-3 * fixed);
  // A load that turns against the rollers passes them faster; the mean over a turn is the same.
  scene.operation.rotating_load = scene.operation.radial_load;
  scene.operation.radial_load = 0;
  for (const double rpm : {-3000.0, 500.0}) {
    scene.operation.rotating_speed = rpm * kPerRpm;
    EXPECT_NEAR(quantity(simulate(scene), "ring_displacement_mean_um"), fixed, 1e-3 * fixed) << rpm;
  }
}

}  // namespace
}  // namespace cagetol
