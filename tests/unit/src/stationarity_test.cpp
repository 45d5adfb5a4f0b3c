// A drift is found, scatter is not taken for one.
#include "src/quantities/stationarity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cagetol {
namespace {

using Means = std::array<double, kDriftBlocks>;

template <class Value>
Means means_of(const Value& value) {
  Means means;
  for (std::size_t i = 0; i < kDriftBlocks; ++i)
    means[i] = value((static_cast<double>(i) + 0.5) / kDriftBlocks);
  return means;
}

TEST(BlockDrift, IsTheChangeAlongTheLine) {
  EXPECT_NEAR(block_drift(means_of([](double x) { return 5 - 3 * x; })).value, -3, 1e-12);
  EXPECT_NEAR(block_drift(means_of([](double) { return 5.0; })).value, 0, 1e-12);
}

// The slope of independent means of standard deviation s has s/sqrt(sum of (x - 1/2)^2), which is
// s/sqrt(12/12 (1 - 1/144)) for 12 blocks; the estimate is a median of 11 differences.
TEST(BlockDrift, ScatterIsTheStandardDeviationOfTheSlope) {
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal(1, 0.01);
  double squares = 0, scatter = 0;
  int alarms = 0;
  constexpr int kTrials = 4000;
  for (int n = 0; n < kTrials; ++n) {
    const Drift drift = block_drift(means_of([&](double) { return normal(engine); }));
    squares += drift.value * drift.value;
    scatter += drift.scatter;
    alarms += drift.exceeds(0);
  }
  EXPECT_NEAR(std::sqrt(squares / kTrials), 0.01 / std::sqrt(143.0 / 144), 0.0004);
  EXPECT_NEAR(scatter / kTrials, 0.01, 0.001);
  EXPECT_LT(alarms, 0.005 * kTrials);
}

TEST(BlockDrift, ASteadyDriftAndATransientAreMoreThanChance) {
  EXPECT_TRUE(block_drift(means_of([](double x) { return x; })).exceeds(0.9));
  EXPECT_FALSE(block_drift(means_of([](double x) { return x; })).exceeds(1.1));
  EXPECT_TRUE(block_drift(means_of([](double x) { return std::exp(-20 * x); })).exceeds(0.1));
}

// Of linear functions trapeziums are exact, wherever blocks end within steps.
TEST(Stationarity, MeansOverBlocksDoNotDependOnTheSteps) {
  for (const int steps : {1, 5, 12, 100, 1001}) {
    Stationarity run(2, 5);
    for (int i = 0; i <= steps; ++i) {
      const double t = 2 + 3.0 * i / steps;
      run.record(t, {10 - t, 100 + t, 4 * t, 2 * t});
    }
    EXPECT_NEAR(run.speed_drift().value, -3, 1e-9) << steps;
    EXPECT_NEAR(run.energy_drift().value, 3, 1e-9) << steps;
    const Stationarity::Seen mean = run.mean();
    EXPECT_NEAR(mean.cage_speed, 6.5, 1e-9) << steps;
    EXPECT_NEAR(mean.energy, 103.5, 1e-9) << steps;
    EXPECT_NEAR(mean.drive, 14, 1e-9) << steps;
    EXPECT_NEAR(mean.loss, 7, 1e-9) << steps;
  }
}

/// What is found in a window of 2 s where cage speed and energy change by these shares of 100 rad/s
/// and 50 J, and 10 W are dissipated.
std::string found(double speed, double energy, double direction = 1) {
  Stationarity run(0, 2);
  for (int i = 0; i <= 600; ++i) {
    const double t = i / 300.0, wave = 1 + 0.001 * std::sin(50 * t);
    run.record(t, {direction * 100 * (wave + speed * t / 2), 50 * (wave + energy * t / 2), 8, 10});
  }
  return run.find_drift(
      {.kinematic_speed = direction * 100, .cage_drift_max = 0.01, .power_surplus_max = 0.3});
}

TEST(Stationarity, NamesWhatDrifts) {
  for (const double direction : {1.0, -1.0}) {
    EXPECT_EQ(found(0, 0, direction), "");
    EXPECT_EQ(found(0.008, 0.016, direction), "");
    const std::string speed = found(-0.012, 0, direction);
    EXPECT_TRUE(speed.starts_with("the mean speed of the cage changes by -1.2")) << speed;
    EXPECT_TRUE(speed.ends_with("more than 1 % and than chance")) << speed;
    EXPECT_TRUE(found(0, 0.024, direction).starts_with("the energy of motion changes by 2.3"))
        << found(0, 0.024, direction);
  }
}

// 0.02 of 50 J in 2 s are 0.5 W.
TEST(Stationarity, PowerThatIsStoredOrGivenBackIsNotLost) {
  const auto balance = [](double loss) {
    Stationarity run(0, 2);
    for (int i = 0; i <= 600; ++i) {
      const double t = i / 300.0;
      run.record(t, {100, 50 - 0.5 * t, loss - 0.5, loss});
    }
    return run.find_drift(
        {.kinematic_speed = 100, .cage_drift_max = 0.02, .power_surplus_max = 0.1});
  };
  EXPECT_EQ(balance(5.1), "");
  EXPECT_TRUE(
      balance(4).starts_with("drive and load give 3.5 W, 4 W are dissipated: the energy of "
                             "motion changes by -12.5 % of that, more than 10 %"))
      << balance(4);
}

}  // namespace
}  // namespace cagetol
