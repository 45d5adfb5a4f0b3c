#include "mc/sample_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "mc/sample_run.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kPoints = 40;

Scene short_scene() {
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
  double at(double time) const {
    const auto after = std::lower_bound(t.begin(), t.end(), time) - t.begin();
    const auto k = static_cast<std::size_t>(after);
    const double share = (time - t[k - 1]) / (t[k] - t[k - 1]);
    return value[k - 1] + share * (value[k] - value[k - 1]);
  }
};

double channel_value(const char* name, const Instant& at) {
  for (const BearingChannel& channel : bearing_channels())
    if (std::string_view(channel.name) == name) return channel.value(at);
  return NAN;
}

class SampleHistoryTest : public testing::Test {
 protected:
  SampleHistoryTest() {
    run_ = run_sample({.points = kPoints, .roller = 4}, scene_, {}, [this](const Instant& at) {
      for (auto& [name, curve] : curves_) {
        curve.t.push_back(at.t);
        curve.value.push_back(channel_value(name, at));
      }
      spin_.t.push_back(at.t);
      spin_.value.push_back(30 / M_PI * at.y[at.system.model.layout.velocity(kSpin, 4)]);
    });
  }
  Scene scene_ = short_scene();
  std::vector<std::pair<const char*, Curve>> curves_ = {
      {"ring_z", {}}, {"cage_y", {}}, {"cage_speed", {}}, {"cage_velocity", {}}};
  Curve spin_;
  SampleRun run_;
};

TEST_F(SampleHistoryTest, InstantsAreEquallySpacedUpToTheEndOfTheWindow) {
  ASSERT_EQ(run_.outcome.status, Status::ok) << run_.outcome.reason;
  const auto time = column(run_, "time");
  EXPECT_EQ(time.back(), run_.outcome.run.simulated_s);
  const double window = time.back() * 0.2 / 0.25;
  for (std::size_t i = 0; i < kPoints; ++i)
    EXPECT_NEAR(time[i], time.back() - window * double(kPoints - 1 - i) / kPoints, 1e-12);
}

TEST_F(SampleHistoryTest, ValuesLieOnTheLineBetweenAcceptedStates) {
  const auto time = column(run_, "time");
  for (const auto& [name, curve] : curves_) {
    const auto values = column(run_, name);
    for (std::size_t i = 0; i < kPoints; ++i)
      EXPECT_NEAR(values[i], curve.at(time[i]), 1e-9 * (1 + std::abs(values[i]))) << name << i;
    EXPECT_EQ(values.back(), curve.value.back()) << name;
  }
  const auto spin = column(run_, "roller_spin");
  for (std::size_t i = 0; i < kPoints; ++i) EXPECT_NEAR(spin[i], spin_.at(time[i]), 1e-5);
}

TEST_F(SampleHistoryTest, SpeedsAreTheSlopesOfPlaces) {
  const Curve &y = curves_[1].second, &speed = curves_[3].second;
  for (std::size_t i = 1; i < y.t.size(); ++i) {
    const double slope = 1e-6 * (y.value[i] - y.value[i - 1]) / (y.t[i] - y.t[i - 1]);
    EXPECT_LE(std::abs(slope), 1.05 * std::max(speed.value[i], speed.value[i - 1]) + 1e-4);
  }
}

TEST_F(SampleHistoryTest, AHistoryChangesNothingOfTheOutcome) {
  const SampleRun plain = run_sample({}, scene_, {});
  EXPECT_TRUE(plain.history.empty());
  EXPECT_EQ(plain.outcome.run.steps, run_.outcome.run.steps);
  EXPECT_EQ(plain.outcome.quantities[0], run_.outcome.quantities[0]);
}

TEST_F(SampleHistoryTest, ARunThatEndsEarlyLeavesTheRestUndefined) {
  scene_.integration.step_budget = static_cast<long>(0.6 * run_.outcome.run.steps);
  const SampleRun cut = run_sample({.points = kPoints, .roller = 4}, scene_, {});
  ASSERT_EQ(cut.outcome.status, Status::censored);
  const auto whole = column(run_, "cage_speed"), part = column(cut, "cage_speed");
  EXPECT_EQ(part.front(), whole.front());
  EXPECT_TRUE(std::isnan(part.back()));
}

}  // namespace
}  // namespace cagetol
