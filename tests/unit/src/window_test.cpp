// What depends on the length of a run's window.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "src/quantities/quantity_table.hpp"
#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// A lubricated NU 205 with short contacts.
Scene quick_scene() {
  Scene scene = shipped_scene("nu205");
  scene.discretisation.bar_stations = 1;
  scene.integration.method = IntegrationMethod::rodas3;
  scene.integration.tolerance = 0.015;
  scene.window = {.settle_revolutions = 1, .measure_revolutions = 2, .peak_revolutions = 2};
  return scene;
}

double value_of(const Outcome& outcome, const std::string& key) {
  return outcome.quantities[static_cast<std::size_t>(quantity_index(key))];
}

TEST(Window, PeaksOfTheSameRevolutionsAreTheSameInALongerWindow) {
  Scene scene = quick_scene();
  const Outcome brief = simulate(scene);
  scene.window.measure_revolutions = 4;
  const Outcome longer = simulate(scene);
  ASSERT_EQ(brief.status, Status::ok) << brief.reason;
  ASSERT_EQ(longer.status, Status::ok) << longer.reason;
  for (const Quantity& row : quantity_table())
    if (is_extreme(row.kind) && !std::isnan(value_of(brief, row.key))) {
      EXPECT_EQ(value_of(brief, row.key), value_of(longer, row.key)) << row.key;
    }
  EXPECT_NE(value_of(brief, "pocket_force_rms_N"), value_of(longer, "pocket_force_rms_N"));
}

// At 40 N the cage skids by more than a fifth, at 1 N by nearly all.
TEST(Window, CountsTurnsThatTheCageMakesUpToThreeTimesItsLength) {
  Scene scene = quick_scene();
  scene.operation.radial_load = 40;
  const double length = 2 * window_times(scene, make_bearing_model(scene)).revolution;
  const Outcome skids = simulate(scene);
  ASSERT_EQ(skids.status, Status::ok) << skids.reason;
  EXPECT_NEAR(skids.run.cage_revolutions, 2, 0.01);
  EXPECT_EQ(skids.run.windows_cut, 0);
  EXPECT_GT(skids.run.measured_s, 1.25 * length);
  EXPECT_NEAR(skids.run.measured_s * (1 - value_of(skids, "cage_slip_ratio")), length,
              0.01 * length);
  scene.operation.radial_load = 1;
  scene.operation.inner_speed *= 3;
  const Outcome stands = simulate(scene);
  ASSERT_EQ(stands.status, Status::ok) << stands.reason;
  EXPECT_LT(stands.run.cage_revolutions, 1.9);
  EXPECT_EQ(stands.run.windows_cut, 1);
  EXPECT_NEAR(stands.run.measured_s, length, 1e-9);  // three times a third
}

// Below twenty turns nothing tells whirl.
TEST(Window, WhirlNeedsTwentyTurns) {
  Scene scene = quick_scene();
  scene.window = {.settle_revolutions = 1, .measure_revolutions = 19.5};
  EXPECT_TRUE(std::isnan(value_of(simulate(scene), "whirl_ratio")));
  scene.window.measure_revolutions = 20;
  const Outcome outcome = simulate(scene);
  EXPECT_LT(value_of(outcome, "whirl_ratio"), 0.5);
  scene.window.whirl_clearance = 2 * whirl_clearance(make_bearing_model(scene));
  EXPECT_DOUBLE_EQ(value_of(simulate(scene), "whirl_ratio"), value_of(outcome, "whirl_ratio") / 2);
}

// A pocket as wide as its roller leaves nothing to take whirl over.
TEST(Window, WhirlOverNoClearanceHasNoValue) {
  Scene scene = quick_scene();
  scene.cage.pocket_width = scene.roller.diameter;
  scene.allow_interference = true;
  scene.window = {.settle_revolutions = 1, .measure_revolutions = 20};
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_TRUE(std::isnan(value_of(outcome, "whirl_ratio")));
}

TEST(Window, ARunThatNeedsTooManyStepsIsCensored) {
  Scene scene = shipped_scene("speed-z16");
  scene.integration.max_step = 1e-15;
  scene.window = {.settle_revolutions = 0, .measure_revolutions = 1e-6, .peak_revolutions = 1};
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::censored);
  EXPECT_EQ(outcome.run.steps, 1e5 + 1);
  EXPECT_THAT(outcome.reason, testing::HasSubstr("(integration.step_budget)"));
}

TEST(Window, ADriftingMotionSettlesLongerAndThenFails) {
  Scene scene = quick_scene();
  scene.operation.radial_load = 0;
  scene.operation.inner_speed *= 2;
  scene.start.state = StartState::equilibrium;
  scene.window.longest_settle_revolutions = 5;
  const Outcome drifting = simulate(scene);
  EXPECT_EQ(drifting.status, Status::failed);
  EXPECT_TRUE(drifting.reason.starts_with("not stationary after")) << drifting.reason;
  const double settle = window_times(scene, make_bearing_model(scene)).settle;
  EXPECT_GT(drifting.run.simulated_s - drifting.run.measured_s, 2 * settle);  // it began anew
}

}  // namespace
}  // namespace cagetol
