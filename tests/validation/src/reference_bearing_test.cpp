// Short runs of the NU 205 under the conditions methods fail in, and what must not change a result.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene short_run(double settle = 4e-3, double measure = 6e-3) {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_time = settle;
  scene.window.measure_time = measure;
  return scene;
}

struct Condition {
  const char* name;
  double load, gravity;
  double consistency;  ///< bound of the watch on statics
};

class ReferenceBearing : public testing::TestWithParam<Condition> {};

// From no load at all to 10 kN. Without load the ring bounces on its own weight: only its force
// counts.
TEST_P(ReferenceBearing, RunsWithinItsWatches) {
  Scene scene = short_run();
  scene.operation.radial_load = GetParam().load;
  scene.operation.gravity = GetParam().gravity;
  scene.watch.static_consistency_max = GetParam().consistency;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
}

INSTANTIATE_TEST_SUITE_P(Loads, ReferenceBearing,
                         testing::Values(Condition{"Default", 1000, 9.81, 0.005},
                                         Condition{"NoLoad", 0, 9.81, 0.02},
                                         Condition{"Weightless", 0, 0, 0.02},
                                         Condition{"Heavy", 10000, 9.81, 0.005}),
                         [](const auto& test) { return test.param.name; });

TEST(ReferenceBearing, TwoRunsAreTheSameToTheBit) {
  const Scene scene = short_run(1e-3, 2e-3);
  const Outcome a = simulate(scene), b = simulate(scene);
  ASSERT_EQ(a.quantities.size(), b.quantities.size());
  for (std::size_t k = 0; k < a.quantities.size(); ++k)
    EXPECT_TRUE(a.quantities[k] == b.quantities[k] ||
                (std::isnan(a.quantities[k]) && std::isnan(b.quantities[k])))
        << quantity_table()[k].key;
  EXPECT_EQ(a.run.steps, b.run.steps);
  EXPECT_EQ(a.run.energy_residual, b.run.energy_residual);
}

TEST(ReferenceBearing, AUniformCageHasNoFirstPocket) {
  // Turning rollers and cage by one pitch renames the rollers, no more; rounding stays small over
  // so short a time, and so do steps that end a little apart.
  Scene scene = short_run(0.5e-3, 1e-3);
  scene.integration.tolerance = 2e-6;
  const Outcome plain = simulate(scene);
  scene.start.cage_phase = 2 * std::numbers::pi / 13;
  const Outcome shifted = simulate(scene);
  ASSERT_EQ(plain.status, shifted.status) << plain.reason << shifted.reason;
  for (const char* key :
       {"cage_slip_ratio", "roller_slip_ratio_all", "ring_displacement_mean_um",
        "pocket_force_rms_N", "power_loss_W", "whirl_radius_ratio_mean", "roller_skew_rms_mrad"}) {
    const double a = quantity(plain, key), b = quantity(shifted, key);
    EXPECT_NEAR(b, a, 1e-4 * std::abs(a) + 1e-9) << key;
  }
}

TEST(ReferenceBearing, JamNamesPocketAndInterference) {
  Scene scene = short_run(1e-3, 1e-3);
  scene.cage.pocket_width.assign(13, 7.65e-3);
  scene.cage.pocket_width[5] = 7.48e-3;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::jammed);
  EXPECT_EQ(outcome.pocket, 5);
  EXPECT_NEAR(outcome.interference_um, 20, 1e-6);
  EXPECT_NE(outcome.reason.find("pocket 5"), std::string::npos) << outcome.reason;
  EXPECT_NE(outcome.reason.find("20 um"), std::string::npos) << outcome.reason;
  EXPECT_TRUE(std::all_of(outcome.quantities.begin(), outcome.quantities.end(),
                          [](double q) { return std::isnan(q); }));
  EXPECT_EQ(outcome.run.steps, 0);
}

TEST(ReferenceBearing, AllowedInterferenceRunsAndIsFlagged) {
  Scene scene = short_run(1e-3, 2e-3);
  scene.cage.pocket_width.assign(13, 7.65e-3);
  scene.cage.pocket_width[5] = 7.498e-3;
  scene.allow_interference = true;
  const Outcome outcome = simulate(scene);
  EXPECT_TRUE(outcome.status == Status::ok || outcome.status == Status::failed)
      << status_name(outcome.status);
  EXPECT_GT(outcome.run.steps, 0);
  EXPECT_EQ(outcome.pocket, 5);  // flagged: the pinched pocket is named
  EXPECT_NEAR(outcome.interference_um, 2, 1e-6);
}

/// One slice rights no tilted roller: every number of such a run looks well, and means nothing.
TEST(ReferenceBearing, TumblingRollersAreAFailedRun) {
  Scene scene = short_run(20e-3, 20e-3);
  scene.discretisation.race_slices = 1;
  scene.watch.static_consistency_max = 1;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_NE(outcome.reason.find("race_slices"), std::string::npos) << outcome.reason;
}

/// Damping that holds rollers off the races as they go round leaves statics nothing to find: the
/// run says so instead of passing unwatched.
TEST(ReferenceBearing, SaysWhereStaticsFindNothing) {
  Scene scene = short_run();
  scene.lubrication.model = LubricationModel::none;
  scene.contact.race.restitution = 0.01;
  scene.contact.race.restitution_speed = 5e-4;
  scene.integration.step_budget = 1e6;  // rollers chatter at the races
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_GE(outcome.run.static_positions_missed, 56);  // of 64
  EXPECT_NE(outcome.reason.find("of 64 roller positions"), std::string::npos) << outcome.reason;
  EXPECT_EQ(simulate(short_run()).run.static_positions_missed, 0);
}

}  // namespace
}  // namespace cagetol
