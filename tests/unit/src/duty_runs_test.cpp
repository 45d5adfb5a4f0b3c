// Whole runs under a duty over time: start, stop, reversal, oscillation, changing loads.
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kPerRpm = std::numbers::pi / 30;

Scene duty_scene(bool oiled) {
  Scene scene = oiled ? shipped_scene("nu205") : dry_scene("nu205");
  scene.cage.model = CageKind::rigid;
  scene.window = {};
  return scene;
}

double at_phase(const Outcome& outcome, const std::string& name) {
  const int index = labelled_index(name, outcome.labels);
  if (index < 0) {
    ADD_FAILURE() << "no quantity " << name;
    return std::nan("");
  }
  return outcome.quantities[static_cast<std::size_t>(index)];
}

// A table that says at all times what the scene says changes neither motion nor meaning.
TEST(DutyRuns, AConstantTableIsTheConstantScene) {
  for (const bool oiled : {false, true}) {
    Scene scene = duty_scene(oiled);
    scene.window.settle_time = 2e-3;
    scene.window.measure_time = 30e-3;
    const Outcome constant = simulate(scene);
    ASSERT_EQ(constant.status, Status::ok) << constant.reason;
    scene.operation.table.time = {{0, 1}};
    scene.operation.table.inner_speed = {
        {scene.operation.inner_speed, scene.operation.inner_speed}};
    scene.operation.inner_speed = 1;
    const Outcome table = simulate(scene);
    ASSERT_EQ(table.status, Status::ok) << table.reason;
    for (const char* key :
         {"cage_slip_ratio", "driving_slip_ratio", "roller_slip_ratio_loaded",
          "roller_slip_ratio_all", "friction_torque_Nmm", "power_loss_W", "whirl_frequency_ratio",
          "cage_speed_std_ratio", "roller_speed_std_ratio", "pocket_impacts_per_revolution",
          "pocket_impulse_N_s", "whirl_resting_share", "load_zone_mean_deg",
          "pocket_force_peak_N"}) {
      const double value = quantity(constant, key);
      EXPECT_NEAR(quantity(table, key), value, 1e-6 * std::abs(value) + 1e-9) << key;
    }
  }
}

// From rest to 3000 rpm, back through zero to -3000, and to a stop.
TEST(DutyRuns, StartReversalAndStopEndWell) {
  for (const bool oiled : {false, true}) {
    Scene scene = duty_scene(oiled);
    const double w = 3000 * kPerRpm;
    scene.operation.inner_speed = 0;
    scene.operation.table.time = {{0, 5e-3, 15e-3, 25e-3, 35e-3, 40e-3, 44e-3}};
    scene.operation.table.inner_speed = {{0, 0, w, w, -w, -w, 0}};
    scene.phase.name = {"rest", "start", "reversal", "stop"};
    scene.phase.from = {{0, 5e-3, 25e-3, 40e-3}};
    scene.phase.to = {{5e-3, 15e-3, 35e-3, 44e-3}};
    const Outcome outcome = simulate(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    EXPECT_EQ(outcome.run.simulated_s, 44e-3);
    for (const char* key : {"cage_slip_ratio", "driving_slip_ratio", "roller_slip_ratio_loaded"})
      EXPECT_LT(std::abs(quantity(outcome, key)), 0.5) << key << ", " << oiled;
    EXPECT_GT(quantity(outcome, "power_loss_W"), 0);
    EXPECT_GT(quantity(outcome, "friction_torque_Nmm"), 0);
    // A ring at rest drives nothing.
    EXPECT_TRUE(std::isnan(at_phase(outcome, "cage_slip_ratio@rest")));
    EXPECT_LT(at_phase(outcome, "power_loss_W@rest"), at_phase(outcome, "power_loss_W@reversal"));
    EXPECT_GT(at_phase(outcome, "ring_displacement_mean_um@rest"), 15);
  }
}

// Seen in a mirror the other way round: means count along the turning.
TEST(DutyRuns, AReversedDutyHasTheSameSlipAndTorque) {
  Scene scene = duty_scene(true);
  scene.operation.gravity = 0;
  scene.bearing.misalignment_z = 0;
  scene.start.cage_phase = std::numbers::pi / 2;
  scene.start.state = StartState::equilibrium;
  scene.integration.tolerance = 1e-4;
  scene.operation.table.time = {{0, 2e-3}};
  scene.operation.table.inner_speed = {{600, 300}};
  const Outcome there = simulate(scene);
  for (double& speed : scene.operation.table.inner_speed.values) speed *= -1;
  const Outcome back = simulate(scene);
  for (const char* key : {"cage_slip_ratio", "driving_slip_ratio", "roller_slip_ratio_loaded",
                          "friction_torque_Nmm", "power_loss_W"}) {
    const double value = quantity(there, key);
    EXPECT_NE(value, 0) << key;
    EXPECT_NEAR(quantity(back, key), value, 5e-3 * std::abs(value)) << key;
  }
}

TEST(DutyRuns, AnOscillatingRingTurnsCageAndRollersToAndFro) {
  for (const bool oiled : {false, true}) {
    Scene scene = duty_scene(oiled);
    DutyTable& table = scene.operation.table;
    constexpr int kInstants = 40;  // of a period; 20 degrees from the middle, 50 times a second
    constexpr double kRate = 2 * std::numbers::pi * 50, kAmplitude = 20 * std::numbers::pi / 180;
    for (int i = 0; i <= kInstants; ++i) {
      table.time.values.push_back(0.02 * i / kInstants);
      table.inner_speed.values.push_back(kAmplitude * kRate *
                                         std::sin(kRate * table.time.values.back()));
    }
    table.inner_speed.values.back() = 0;
    table.repeat = 0.02;
    const WindowTimes times = window_times(scene, make_bearing_model(scene));
    EXPECT_DOUBLE_EQ(times.settle, 0.02);
    EXPECT_DOUBLE_EQ(times.measure, 0.02);
    const Outcome outcome = simulate(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    EXPECT_LT(std::abs(quantity(outcome, "driving_slip_ratio")), 0.3);
    // 80 degrees of the ring a period, of the cage 0.404 of that.
    const BearingModel model = make_bearing_model(scene);
    const double share = model.inner_radius / (model.inner_radius + model.outer_radius);
    EXPECT_NEAR(outcome.run.cage_revolutions, share * 80 / 360, 0.3 * share * 80 / 360);
  }
}

TEST(DutyRuns, TheRingFollowsAChangingLoadLikeEquilibria) {
  Scene scene = duty_scene(false);
  scene.operation.table.time = {{0, 10e-3, 20e-3}};
  scene.operation.table.radial_load = {{1000, 4000, 1000}};
  scene.operation.table.repeat = 20e-3;
  const Outcome moving = simulate(scene);
  ASSERT_EQ(moving.status, Status::ok) << moving.reason;
  scene.model.motion = MotionModel::quasi_static;
  const Outcome still = simulate(scene);
  ASSERT_EQ(still.status, Status::ok) << still.reason;
  const double mean = quantity(still, "ring_displacement_mean_um");
  EXPECT_NEAR(quantity(moving, "ring_displacement_mean_um"), mean, 0.01 * mean);
  scene.operation.table = {};
  const double light = quantity(simulate(scene), "ring_displacement_mean_um");
  scene.operation.radial_load = 4000;
  const double heavy = quantity(simulate(scene), "ring_displacement_mean_um");
  EXPECT_GT(mean, light + 0.3 * (heavy - light));
  EXPECT_LT(mean, light + 0.7 * (heavy - light));
}

// Faster races make thicker films, which bend races and rollers further: that energy comes from the
// drive and is no loss.
TEST(DutyRuns, TheAccountOfEnergyHoldsWhileRingsSpeedUp) {
  Scene scene = shipped_scene("nu208-planet");
  scene.cage.model = CageKind::rigid;
  scene.operation.table.time = {{0, 10e-3}};
  scene.operation.table.outer_speed = {{100 * kPerRpm, 400 * kPerRpm}};
  // Of a single run's residual a third is chance.
  constexpr int starts = 4;
  double residual = 0;
  for (int k = 0; k < starts; ++k) {
    scene.start.cage_phase = k * std::numbers::pi / 180;
    const Outcome outcome = simulate(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    residual += outcome.run.energy_residual / starts;
  }
  EXPECT_LT(residual, 0.002);
}

TEST(DutyRuns, EquilibriaFollowADutyThroughStandstill) {
  for (const bool oiled : {false, true}) {
    Scene scene = duty_scene(oiled);
    scene.model.motion = MotionModel::quasi_static;
    const double w = 3000 * kPerRpm;
    scene.operation.table.time = {{0, 10e-3, 20e-3, 30e-3}};
    scene.operation.table.inner_speed = {{0, 0, w, -w}};
    const Outcome outcome = simulate(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    // The cage turns with a mean of half the speed over 10 ms, then to and fro.
    const BearingModel m = make_bearing_model(scene);
    const double share = m.inner_radius / (m.inner_radius + m.outer_radius);
    EXPECT_NEAR(outcome.run.cage_revolutions, share * 50 * (5e-3 + 5e-3), 1e-3);
  }
}

// A phase that is the window has its values to the bit.
TEST(DutyRuns, APhaseIsAWindowOfItsOwn) {
  Scene scene = duty_scene(true);
  scene.operation.table.time = {{0, 4e-3, 8e-3}};
  scene.operation.table.radial_load = {{500, 3000, 500}};
  scene.phase.name = {"late", "all"};
  scene.phase.from = {{4e-3, 1e-3}};
  scene.phase.to = {{8e-3, 8e-3}};
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  const std::size_t count = quantity_table().size();
  ASSERT_EQ(outcome.quantities.size(), 3 * count);
  bool differs = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = outcome.quantities[i], same = outcome.quantities[2 * count + i];
    EXPECT_TRUE(value == same || (std::isnan(value) && std::isnan(same)))
        << quantity_table()[i].key << ": " << value << ", " << same;
    differs = differs || value != outcome.quantities[count + i];
  }
  EXPECT_TRUE(differs);
}

}  // namespace
}  // namespace cagetol
