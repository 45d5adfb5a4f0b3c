// No value beyond what a bearing can do is a result, and nothing that a bearing does is refused.
#include "src/quantities/plausibility.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <set>

#include "src/simulate.hpp"
#include "src/window_times.hpp"
#include "tests/support/not_a_number.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Scene brief_run(Scene scene, double settle = 1e-3, double measure = 2e-3) {
  scene.window.settle_time = settle;
  scene.window.measure_time = measure;
  scene.watch.static_consistency_max = scene.watch.energy_residual_max = 1e9;
  return scene;
}

PlausibleReach reach_of(const Scene& scene, const Outcome& outcome) {
  const BearingModel model = make_bearing_model(scene);
  const WindowTimes times = window_times(scene, model);
  return {scene,
          model,
          {times.settle, times.settle + times.measure, outcome.run.cage_revolutions,
           outcome.run.steps, is_quasi_static(scene)}};
}

std::size_t index_of(const char* key) {
  return static_cast<std::size_t>(quantity_index(key));
}

/// A run of the reference bearing, and what it could have been.
struct Healthy {
  Scene scene = brief_run(shipped_scene("nu205"));
  Outcome outcome = simulate(scene);
  PlausibleReach reach = reach_of(scene, outcome);
};
const Healthy& healthy() {
  static const Healthy run;
  return run;
}

TEST(Plausibility, EveryQuantityHasOneRowWithItsReasonAndRemedy) {
  std::set<std::string> keys;
  for (const PlausibleRow& row : plausible_rows()) {
    EXPECT_GE(quantity_index(row.key), 0) << row.key;
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_GT(std::string(row.reason).size(), 20u) << row.key;
    EXPECT_GT(std::string(row.remedy).size(), 20u) << row.key;
  }
  EXPECT_EQ(keys.size(), quantity_table().size());
}

/// Asks for every row: elastic, tilting, filmed, turning.
PlausibleReach all_kinds() {
  PlausibleReach reach = healthy().reach;
  reach.flexible = reach.tilts = true;
  reach.stations = 100;
  return reach;
}
std::vector<double> all_given() {
  std::vector<double> q = healthy().outcome.quantities;
  for (double& x : q)
    if (std::isnan(x)) x = 0;
  return q;
}

TEST(Plausibility, AValueBeyondEitherBoundOfEachQuantityIsNamedWithReasonAndRemedy) {
  const PlausibleReach reach = all_kinds();
  const std::vector<double> good = all_given();
  ASSERT_EQ(find_implausible(reach, good), "");
  for (const PlausibleRow& row : plausible_rows()) {
    const auto [low, high] = row.range(reach);
    EXPECT_LT(low, high) << row.key;
    EXPECT_TRUE(std::isfinite(low) || std::isfinite(high)) << row.key;
    for (const double bound : {low, high}) {
      if (std::isinf(bound)) continue;
      const double over = std::abs(bound) * 1e-6 + 1e-9;
      std::vector<double> bad = good;
      bad[index_of(row.key)] = bound == low ? low - over : high + over;
      const std::string reason = find_implausible(reach, bad);
      EXPECT_TRUE(reason.starts_with(std::string(row.key) + " = ")) << row.key << ": " << reason;
      EXPECT_NE(reason.find(row.reason), std::string::npos) << reason;
      EXPECT_NE(reason.find(row.remedy), std::string::npos) << reason;
      bad[index_of(row.key)] = bound;  // possible itself, though perhaps more than the peak
      EXPECT_EQ(find_implausible(reach, bad).find(row.reason), std::string::npos) << row.key;
    }
  }
}

TEST(Plausibility, NoNumberWhereOneIsExpectedAndInfinityAnywhereAreNamed) {
  const PlausibleReach reach = all_kinds();
  for (const PlausibleRow& row : plausible_rows())
    for (const double nothing : {kNan, kInfinite, -kInfinite}) {
      std::vector<double> bad = all_given();
      bad[index_of(row.key)] = nothing;
      const bool wrong = std::isinf(nothing) || row.expected(reach);
      EXPECT_EQ(find_implausible(reach, bad).starts_with(std::string(row.key) + " is "), wrong)
          << row.key << ", " << nothing;
    }
}

TEST(Plausibility, AMeanOrQuantileAboveThePeakIsNamed) {
  const PlausibleReach reach = all_kinds();
  for (const PlausibleOrder& order : plausible_orders()) {
    std::vector<double> bad = all_given();
    for (const PlausibleOrder& other : plausible_orders())
      if (other.greater == std::string(order.greater)) bad[index_of(other.lesser)] = 0;
    bad[index_of(order.greater)] = 1e-3;
    bad[index_of(order.lesser)] = 1;
    EXPECT_TRUE(find_implausible(reach, bad).find(order.reason) != std::string::npos)
        << order.lesser;
  }
}

// Numbers by hand: the bounds are wide, but not endless.
TEST(Plausibility, BoundsOfTheReferenceBearing) {
  const PlausibleReach& reach = healthy().reach;
  EXPECT_DOUBLE_EQ(reach.stress, 0.05 * 206e9);  // 5 % strain of steel
  EXPECT_GT(reach.ring_move, 15e-6);             // half of 30 um of clearance is free
  EXPECT_LT(reach.ring_move, 100e-6);
  EXPECT_GT(reach.whirl / reach.guide_clearance, 1);
  EXPECT_LT(reach.whirl / reach.guide_clearance, 5);
  EXPECT_GT(reach.axial, 0.04e-3 + 0.125e-3);  // half of both clearances
  EXPECT_LT(reach.axial, 2e-3);
}

// A cage goes as far as its guide gives way under the forces of the run, and 1.05 of the clearance.
TEST(Plausibility, ACageOutsideItsGuideIsAFailedRun) {
  std::vector<double> out = healthy().outcome.quantities;
  for (const char* key : {"whirl_radius_ratio_peak", "whirl_radius_ratio_p95"})
    out[index_of(key)] = 1.2;
  out[index_of("guide_force_peak_N")] = 100;
  const std::string reason = find_implausible(healthy().reach, out);
  EXPECT_TRUE(reason.starts_with("whirl_radius_ratio_peak")) << reason;
  EXPECT_NE(reason.find("left its guide"), std::string::npos) << reason;
  EXPECT_NE(reason.find("cage.guidance = \"outer\""), std::string::npos) << reason;
  out[index_of("guide_force_peak_N")] = 2500;  // by K p^(10/9): 25 um of one contact
  EXPECT_EQ(find_implausible(healthy().reach, out), "");
}

TEST(Plausibility, AQuasiStaticRunIsJudgedToo) {
  Scene scene = shipped_scene("nu205");
  scene.model.motion = MotionModel::quasi_static;
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  const PlausibleReach reach = reach_of(scene, outcome);
  EXPECT_EQ(find_implausible(reach, outcome.quantities), "");
  for (const char* key : {"ring_displacement_mean_um", "ring_orbit_p95_um"}) {
    std::vector<double> bad = outcome.quantities;
    bad[index_of(key)] = 1e3;
    EXPECT_TRUE(find_implausible(reach, bad).starts_with(key));
    bad[index_of(key)] = kNan;
    EXPECT_TRUE(find_implausible(reach, bad).starts_with(key));
  }
}

/// Legal scenes of every kind: bounds leave them alone.
TEST(Plausibility, RandomScenesAreNeverImpossible) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    Scene scene = brief_run(random_scene(seed), 0.5e-3, 1e-3);
    scene.integration.tolerance = 0.01;
    if (seed % 5 == 1) scene.operation.inner_speed = scene.operation.speed_ramp = 0;
    if (seed % 5 == 2) scene.operation.radial_load = 0;
    if (seed % 5 == 3) scene.model.rollers = RollerModel::planar;
    if (seed % 5 == 4) scene.film.model = FilmModel::series;
    const Outcome outcome = simulate(scene);
    EXPECT_EQ(outcome.reason.find("impossible"), std::string::npos)
        << seed << ": " << outcome.reason;
    if (outcome.status != Status::ok) continue;
    // Not by a hair either: forces have room to double.
    const PlausibleReach reach = reach_of(scene, outcome);
    for (const char* key : {"pocket_force_peak_N", "guide_force_peak_N", "end_force_peak_N"}) {
      std::vector<double> larger = outcome.quantities;
      larger[index_of(key)] *= 2;
      EXPECT_EQ(find_implausible(reach, larger), "") << seed;
    }
  }
}

}  // namespace
}  // namespace cagetol
