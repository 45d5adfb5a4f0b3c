// No value beyond what a bearing can do is a result, and nothing that a bearing does is refused.
#include "src/quantities/quantity_bounds.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>

#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"
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

/// A scene and its run.
struct Ran {
  explicit Ran(const Scene& of) : scene(of), outcome(simulate(of)), model(make_bearing_model(of)) {
    const WindowTimes times = window_times(scene, model);
    begin = times.settle;
    end = times.settle + times.measure;
  }
  JudgedRun judged(const std::vector<double>& quantities) const {
    return {scene, model, begin, end, quantities};
  }
  std::string problem(const std::vector<double>& quantities) const {
    return find_impossible(judged(quantities));
  }
  /// With another value of a quantity.
  std::vector<double> with(const char* key, double value) const {
    std::vector<double> quantities = outcome.quantities;
    quantities[static_cast<std::size_t>(quantity_index(key))] = value;
    return quantities;
  }
  Scene scene;
  Outcome outcome;
  BearingModel model;
  double begin = 0, end = 0;
};

const Ran& healthy() {
  static const Ran run(brief_run(shipped_scene("nu205")));
  return run;
}

/// The same, with what gives every quantity that a bearing with a cage can have: elastic, tilting,
/// filmed, turning.
const Ran& complete() {
  static const Ran run = [] {
    Ran all = healthy();
    all.scene.cage.model = CageKind::flexible;
    all.scene.model.ring_tilt = TiltModel::free;
    auto cage = std::make_shared<CageModel>();
    cage->stress_stations = 100;
    all.model.flexible.model = cage;
    for (double& x : all.outcome.quantities)
      if (std::isnan(x)) x = 0;
    return all;
  }();
  return run;
}

ValueRange range_of(const Ran& run, const char* key) {
  return quantity_named(key).bound.range(run.judged(run.outcome.quantities));
}

TEST(QuantityBounds, AValueBeyondEitherBoundIsNamedWithReasonAndRemedy) {
  const Ran& run = complete();
  ASSERT_EQ(run.problem(run.outcome.quantities), "");
  for (const Quantity& row : quantity_table()) {
    const auto [low, high] = range_of(run, row.key);
    EXPECT_LT(low, high) << row.key;
    EXPECT_GT(std::string(row.bound.remedy).size(), 20u) << row.key;
    for (const double bound : {low, high}) {
      if (std::isinf(bound)) continue;
      EXPECT_GT(std::string(row.bound.reason).size(), 20u) << row.key;
      const double over = std::abs(bound) * 1e-6 + 1e-9;
      const std::string said =
          run.problem(run.with(row.key, bound == low ? low - over : high + over));
      EXPECT_TRUE(said.starts_with(std::string(row.key) + " = ")) << row.key << ": " << said;
      EXPECT_NE(said.find(row.bound.reason), std::string::npos) << said;
      EXPECT_NE(said.find(row.bound.remedy), std::string::npos) << said;
      // The bound itself is possible, though perhaps more than the peak.
      EXPECT_EQ(run.problem(run.with(row.key, bound)).find(row.bound.reason), std::string::npos)
          << row.key;
    }
  }
}

TEST(QuantityBounds, NoNumberWhereOneMustBeAndInfinityAnywhereAreNamed) {
  const Ran& run = complete();
  for (const Quantity& row : quantity_table())
    for (const double nothing : {kNan, kInfinite, -kInfinite}) {
      const bool must = row.need.met(run.scene) && row.need.given != Given::perhaps;
      EXPECT_EQ(run.problem(run.with(row.key, nothing)).starts_with(std::string(row.key) + " is "),
                must || std::isinf(nothing))
          << row.key << ", " << nothing;
    }
}

// A ratio to a speed that is zero says nothing, a force always does.
TEST(QuantityBounds, ARatioToTheSpeedOfACageAtRestMayBeInfinite) {
  Ran run = healthy();
  run.scene.operation.inner_speed = 0;
  run.model = make_bearing_model(run.scene);
  for (const double nothing : {kNan, kInfinite}) {
    EXPECT_EQ(run.problem(run.with("cage_speed_std_ratio", nothing)), "");
    EXPECT_NE(run.problem(run.with("pocket_force_peak_N", nothing)), "");
  }
}

TEST(QuantityBounds, AMeanOrQuantileAboveThePeakIsNamed) {
  const Ran& run = complete();
  for (const Quantity& row : quantity_table()) {
    if (!*row.peak || row.kind == Kind::place) continue;
    const double peak = run.outcome.quantities[static_cast<std::size_t>(quantity_index(row.peak))];
    const std::vector<double> above = run.with(row.key, 2 * peak + 1e-3);
    if (range_of(run, row.key).high < 2 * peak) continue;  // by its own bound
    EXPECT_NE(run.problem(above).find(std::string(" is beyond ") + row.peak), std::string::npos)
        << row.key;
    JudgedRun judged = run.judged(above);
    judged.peaks_in_part = true;  // the peak of a part of the window, the mean of all of it
    EXPECT_EQ(find_impossible(judged).empty(), row.kind == Kind::mean) << row.key;
  }
}

// Numbers by hand: the bounds are wide, but not endless.
TEST(QuantityBounds, BoundsOfTheReferenceBearing) {
  EXPECT_DOUBLE_EQ(range_of(healthy(), "cage_stress_peak_MPa").high, 0.05 * 206e3);  // steel
  const ValueRange ring = range_of(healthy(), "ring_displacement_mean_um");
  EXPECT_GT(ring.high, 15);  // half of 30 um of clearance is free
  EXPECT_LT(ring.high, 100);
  EXPECT_EQ(ring.low, -ring.high);
  const double whirl = range_of(healthy(), "whirl_radius_ratio_peak").high;
  EXPECT_GT(whirl, 1);
  EXPECT_LT(whirl, 2);
  EXPECT_DOUBLE_EQ(range_of(healthy(), "cage_axial_std_um").high,
                   1e6 * healthy().scene.roller.length);
  EXPECT_GT(range_of(healthy(), "power_loss_W").low, -1e4);
  EXPECT_LT(range_of(healthy(), "power_loss_W").low, 0);
}

// Met: whirl ratios of 150 and 7, ok. A cage goes as far as its guide deflects under the forces of
// the run, and 1.05 of the clearance.
TEST(QuantityBounds, ACageOutsideItsGuideIsAFailedRun) {
  Ran run = healthy();
  for (const char* key : {"whirl_radius_ratio_peak", "whirl_radius_ratio_p95"})
    run.outcome.quantities = run.with(key, 1.2);
  const std::string reason = run.problem(run.with("guide_force_peak_N", 100));
  EXPECT_TRUE(reason.starts_with("whirl_radius_ratio_peak")) << reason;
  EXPECT_NE(reason.find("left its guide"), std::string::npos) << reason;
  EXPECT_NE(reason.find("cage.guidance = \"outer\""), std::string::npos) << reason;
  // By K p^(10/9): 25 um of one contact.
  EXPECT_EQ(run.problem(run.with("guide_force_peak_N", 2500)), "");
}

// Met: 8.7e11 m/s2, ok, over a last step as short as rounding leaves it.
TEST(QuantityBounds, AnAccelerationThatNoForceGivesIsAFailedRun) {
  const std::string reason =
      healthy().problem(healthy().with("ring_acceleration_peak_m_s2", 8.7e11));
  EXPECT_TRUE(reason.starts_with("ring_acceleration_peak_m_s2 = 8.7e+11 m/s2 is beyond "))
      << reason;
}

TEST(QuantityBounds, AQuasiStaticRunIsJudgedToo) {
  Scene scene = shipped_scene("nu205");
  scene.model.motion = MotionModel::quasi_static;
  const Ran run(scene);
  ASSERT_EQ(run.outcome.status, Status::ok) << run.outcome.reason;
  EXPECT_EQ(run.problem(run.outcome.quantities), "");
  for (const char* key : {"ring_displacement_mean_um", "ring_orbit_p95_um"}) {
    EXPECT_TRUE(run.problem(run.with(key, 1e3)).starts_with(key));
    EXPECT_TRUE(run.problem(run.with(key, kNan)).starts_with(key));
  }
}

/// Legal scenes of every kind: bounds leave them alone.
TEST(QuantityBounds, RandomScenesAreNeverImpossible) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    Scene scene = brief_run(random_scene(seed), 0.5e-3, 1e-3);
    scene.integration.tolerance = 0.01;
    if (seed % 5 == 1) scene.operation.inner_speed = scene.operation.speed_ramp = 0;
    if (seed % 5 == 2) scene.operation.radial_load = 0;
    const Ran run(scene);
    EXPECT_EQ(run.outcome.reason.find("impossible"), std::string::npos)
        << seed << ": " << run.outcome.reason;
    if (run.outcome.status != Status::ok) continue;
    // Not by a hair either: there is room to double.
    for (const char* key : {"ring_acceleration_peak_m_s2", "ring_displacement_mean_um"})
      EXPECT_EQ(run.problem(run.with(key, 2 * quantity(run.outcome, key))), "") << seed;
  }
}

}  // namespace
}  // namespace cagetol
