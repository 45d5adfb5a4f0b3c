#include "mc/run/sample_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "mc/run/sample_run.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kPoints = 40;

Scene scene_of_a_fifth_turn() {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_revolutions = 0.05;
  scene.window.measure_revolutions = 0.2;
  scene.start.cage_offset_y = 30e-6;
  return scene;
}

std::vector<double> column(const SampleRun& run, const std::string& name) {
  const auto& columns = history_columns();
  const auto found = std::find_if(columns.begin(), columns.end(),
                                  [&](const auto& column) { return column.name == name; });
  const auto first = run.history.begin() + (found - columns.begin()) * std::ptrdiff_t(kPoints);
  return {first, first + kPoints};
}

/// A channel at every accepted state.
struct Curve {
  std::vector<double> t, value;
  /// At the first state at or after an instant.
  double at(double instant) const {
    return value[static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), instant) -
                                          t.begin())];
  }
};

double channel_value(const char* name, const Instant& at) {
  for (const BearingChannel& channel : bearing_channels())
    if (std::string_view(channel.name) == name) return channel.value(at);
  return NAN;
}

class SampleHistoryTest : public testing::Test {
 protected:
  SampleRun run(long points, const std::function<void(const Instant&)>& on_instant = {}) const {
    Study study;
    study.history = {.points = points, .roller = 4};
    Sample sample;
    sample.scene = scene_;
    return run_sample(study, sample, {}, on_instant);
  }
  SampleHistoryTest() {
    run_ = run(kPoints, [this](const Instant& at) {
      for (auto& [name, curve] : curves_) {
        curve.t.push_back(at.t);
        curve.value.push_back(channel_value(name, at));
      }
      spin_.t.push_back(at.t);
      spin_.value.push_back(30 / M_PI * at.y[at.system.model.layout.velocity(kSpin, 4)]);
    });
  }
  Scene scene_ = scene_of_a_fifth_turn();
  std::vector<std::pair<const char*, Curve>> curves_ = {
      {"ring_z", {}}, {"cage_y", {}}, {"cage_speed", {}}, {"cage_velocity", {}}};
  Curve spin_;
  SampleRun run_;
};

/// The i-th of kPoints instants.
double instant(std::size_t i, double end) {
  return i + 1 == kPoints ? end : 0.2 * end + 0.8 * end * double(i + 1) / kPoints - 1e-15;
}

TEST_F(SampleHistoryTest, HoldsTheFirstStateAtOrAfterEquallySpacedInstantsOfTheWindow) {
  ASSERT_EQ(run_.outcome.status, Status::ok) << run_.outcome.reason;
  const WindowTimes window = window_times(scene_, make_bearing_model(scene_));
  const double end = window.settle + window.measure;
  const auto time = column(run_, "time"), spin = column(run_, "roller_spin");
  EXPECT_NEAR(time.back(), end, 60e-6);  // a step is 50 us at most
  for (std::size_t i = 0; i < kPoints; ++i) {
    EXPECT_GE(time[i], instant(i, end));
    EXPECT_NEAR(spin[i], spin_.at(instant(i, end)), 1e-9);
  }
  for (const auto& [name, curve] : curves_) {
    const auto values = column(run_, name);
    for (std::size_t i = 0; i < kPoints; ++i)
      EXPECT_EQ(values[i], curve.at(instant(i, end))) << name << i;
  }
  EXPECT_TRUE(std::isnan(column(run_, "cage_stress")[0]));
}

TEST_F(SampleHistoryTest, SpeedsAreTheSlopesOfPlaces) {
  const Curve &y = curves_[1].second, &speed = curves_[3].second;
  for (std::size_t i = 1; i < y.t.size(); ++i) {
    const double slope = 1e-6 * (y.value[i] - y.value[i - 1]) / (y.t[i] - y.t[i - 1]);
    EXPECT_LE(std::abs(slope), 1.05 * std::max(speed.value[i], speed.value[i - 1]) + 1e-4);
  }
}

TEST_F(SampleHistoryTest, AHistoryChangesNothingOfTheOutcome) {
  const SampleRun plain = run(0);
  EXPECT_TRUE(plain.history.empty());
  EXPECT_EQ(plain.outcome.run.steps, run_.outcome.run.steps);
  EXPECT_EQ(plain.outcome.quantities[0], run_.outcome.quantities[0]);
}

TEST_F(SampleHistoryTest, ARunThatEndsEarlyLeavesTheRestUndefined) {
  scene_.integration.step_budget = static_cast<long>(0.6 * run_.outcome.run.steps);
  const SampleRun cut = run(kPoints);
  ASSERT_EQ(cut.outcome.status, Status::censored);
  const auto whole = column(run_, "cage_speed"), part = column(cut, "cage_speed");
  EXPECT_EQ(part.front(), whole.front());
  EXPECT_TRUE(std::isnan(part.back()));
}

// A lubricated bearing without load, whose cage slows down for many turns: the window begins anew
// once at least.
TEST_F(SampleHistoryTest, IsThatOfTheLastWindowWhereSettlingIsExtended) {
  scene_.lubrication.model = LubricationModel::film;
  scene_.operation.radial_load = 0;
  scene_.discretisation = {.race_slices = 3, .bar_stations = 1};
  scene_.window.settle_revolutions = 0;
  scene_.window.measure_revolutions = 2;
  scene_.window.longest_settle_revolutions = 4;
  scene_.start.state = StartState::equilibrium;
  const SampleRun extended = run(kPoints);
  const RunRecord& ran = extended.outcome.run;
  const double begin = ran.simulated_s - ran.measured_s,
               length = window_times(scene_, make_bearing_model(scene_)).measure;
  EXPECT_GT(begin, length);
  const auto time = column(extended, "time");
  EXPECT_NEAR(time.front(), begin + length / kPoints, 60e-6);
  EXPECT_NEAR(time[kPoints / 2 - 1], begin + length / 2, 60e-6);
  EXPECT_NEAR(time.back(), begin + length, 60e-6);
}

}  // namespace
}  // namespace cagetol
