// When the means of a window count as known, and what a run does with that.
#include "src/quantities/convergence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// Revolutions with these means of one watched quantity, each of weight 0.5.
Convergence watching(WatchedMean of, const std::vector<double>& means) {
  Convergence convergence;
  Convergence::Integrals sums;
  for (const double mean : means) {
    sums[of].value += 0.5 * mean;
    sums[of].weight += 0.5;
    convergence.add(sums);
  }
  return convergence;
}

TEST(Convergence, IsTheIntervalOfStudentOverTheMean) {
  // Mean 2, standard error 1/sqrt(3), and 4.302653 = t of 2 degrees of freedom.
  const MeanShare torque = watching(kMeanTorque, {1, 2, 3}).worst();
  EXPECT_NEAR(torque.share, 4.302653 / std::sqrt(3.0) / 2, 1e-6);
  EXPECT_STREQ(torque.key, "friction_torque_Nmm");
  EXPECT_NEAR(watching(kMeanTorque, {-1, -2, -3}).worst().share, torque.share, 1e-12);
  // A force is the root of a mean square: half the relative error.
  EXPECT_NEAR(watching(kMeanPocketForce, {1, 2, 3}).worst().share, torque.share / 2, 1e-12);
  // A slip of 0.02 % is no better known than one of 0.1 %.
  EXPECT_NEAR(watching(kMeanCageSlip, {1e-4, 2e-4, 3e-4}).worst().share, torque.share / 5, 1e-9);
}

TEST(Convergence, NeedsTwoRevolutionsAndWhatTheRunDefines) {
  EXPECT_TRUE(std::isnan(watching(kMeanTorque, {1}).worst().share));
  EXPECT_EQ(watching(kMeanTorque, {1, 1}).worst().share, 0);
  EXPECT_EQ(watching(kMeanGuideForce, {0, 0, 0}).worst().share, 0);
}

TEST(Convergence, NamesTheQuantityThatIsKnownLeast) {
  Convergence convergence;
  Convergence::Integrals sums;
  for (const double mean : {1.0, 1.1, 0.9, 1.0}) {
    sums[kMeanTorque].value += 10 + mean;
    sums[kMeanGuideForce].value += mean;
    sums[kMeanTorque].weight += 1;
    sums[kMeanGuideForce].weight += 1;
    convergence.add(sums);
  }
  EXPECT_STREQ(convergence.worst().key, "guide_force_rms_N");
}

TEST(Convergence, ItsIntervalHoldsTheMeanOfManyRevolutionsNineteenTimesInTwenty) {
  std::mt19937 random(7);
  std::normal_distribution<double> force(100, 15);
  constexpr int kRuns = 4000;
  int held = 0;
  for (int run = 0; run < kRuns; ++run) {
    std::vector<double> means(4);
    double sum = 0;
    for (double& mean : means) sum += mean = force(random);
    held += std::abs(sum / 4 - 100) <= watching(kMeanTorque, means).worst().share * sum / 4;
  }
  EXPECT_NEAR(held, 0.95 * kRuns, 4 * std::sqrt(0.95 * 0.05 * kRuns));
}

TEST(Convergence, WatchesQuantitiesThatAreMeans) {
  for (const WatchedQuantity& watched : watched_quantities()) {
    EXPECT_GE(quantity_index(watched.key), 0) << watched.key;
    EXPECT_FALSE(is_extreme(quantity_named(watched.key).kind)) << watched.key;
  }
}

/// A lubricated NU 205 with planar rollers, whose window ends by itself.
Scene open_ended(double share, double most) {
  Scene scene = shipped_scene("nu205");
  scene.model.rollers = RollerModel::planar;
  scene.discretisation = {.race_slices = 1, .bar_stations = 1};
  scene.integration.method = IntegrationMethod::rodas3;
  scene.integration.tolerance = 0.015;
  scene.window = {.settle_revolutions = 1,
                  .measure = WindowRule::automatic,
                  .measure_revolutions = most,
                  .measure_share = share,
                  .peak_revolutions = 2};
  return scene;
}

double measured_turns(const Scene& scene, const Outcome& outcome) {
  return outcome.run.measured_s / (outcome.run.simulated_s - outcome.run.measured_s) *
         scene.window.settle_revolutions;
}

double value_of(const Outcome& outcome, const std::string& key) {
  return outcome.quantities[static_cast<std::size_t>(quantity_index(key))];
}

TEST(OpenWindow, MeansLieWithinTheShareOfThoseOfFiveTimesTheTime) {
  const Scene scene = open_ended(0.15, 12);
  const Outcome early = simulate(scene);
  ASSERT_EQ(early.status, Status::ok) << early.reason;
  EXPECT_EQ(early.run.window_end, WindowEnd::converged);
  EXPECT_LE(early.run.mean_share, 0.15);
  const double turns = measured_turns(scene, early);
  EXPECT_NEAR(turns, std::round(turns), 1e-6);
  EXPECT_LT(turns, 11.5);
  Scene longer = scene;
  longer.window.measure = WindowRule::fixed;
  longer.window.measure_revolutions = 5 * std::round(turns);
  const Outcome late = simulate(longer);
  ASSERT_EQ(late.status, Status::ok) << late.reason;
  EXPECT_EQ(late.run.window_end, WindowEnd::fixed);
  EXPECT_LT(late.run.mean_share, early.run.mean_share);
  for (const WatchedQuantity& watched : watched_quantities()) {
    const double mean = value_of(late, watched.key);
    if (std::isnan(mean)) continue;  // no stress in a rigid cage
    EXPECT_NEAR(value_of(early, watched.key), mean, 0.15 * std::abs(mean)) << watched.key;
  }
  // Up to where peaks end both runs are one.
  for (const Quantity& row : quantity_table())
    if (is_extreme(row.kind) && !std::isnan(value_of(early, row.key))) {
      EXPECT_EQ(value_of(early, row.key), value_of(late, row.key)) << row.key;
    }
  EXPECT_NE(value_of(early, "pocket_force_rms_N"), value_of(late, "pocket_force_rms_N"));
}

TEST(OpenWindow, ARunThatNeverConvergesEndsAtTheMost) {
  const Scene scene = open_ended(1e-6, 4);
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_EQ(outcome.run.window_end, WindowEnd::longest);
  EXPECT_NEAR(measured_turns(scene, outcome), 4, 1e-6);
  EXPECT_GT(outcome.run.mean_share, 1e-6);
  EXPECT_FALSE(outcome.least_known.empty());
}

TEST(OpenWindow, ADriftingMotionSettlesLongerAndIsNotTakenForConverged) {
  Scene scene = open_ended(0.5, 8);
  scene.operation.radial_load = 0;
  scene.start.state = StartState::equilibrium;
  scene.window.longest_settle_revolutions = 3;
  const Outcome drifting = simulate(scene);
  EXPECT_EQ(drifting.status, Status::failed);
  EXPECT_TRUE(drifting.reason.starts_with("not stationary after 0.074")) << drifting.reason;
  EXPECT_EQ(drifting.run.window_end, WindowEnd::longest);
}

}  // namespace
}  // namespace cagetol
