// What series of a run amount to: means over uneven steps, and which states the quantiles see.
#include "src/quantities/series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace cagetol {
namespace {

constexpr double kInterval = 20e-6;

std::vector<double> uneven_times(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> length(0.1e-6, 50e-6);
  std::vector<double> times = {0.003};
  while (times.size() < 200) times.push_back(times.back() + length(random));
  return times;
}

TEST(StepSeries, MeanOfALineIsExactHoweverUnevenTheSteps) {
  StepClock clock(0, kInterval);
  StepSeries line;
  for (const double t : {0.0, 1e-6, 2e-6, 40e-6, 41e-6, 100e-6})
    line.add(3 + t / 1e-6, clock.advance(t));
  EXPECT_NEAR(line.mean(), 3 + 50, 1e-12);
}

// Parabolas and their tops: exact but for the first and the last step, which see half of the bow.
TEST(StepSeries, FollowsParabolasThroughNeighbouringStates) {
  const auto hill = [](double t) { return 7 - std::pow((t - 51e-6) / 10e-6, 2); };
  StepClock clock(0, kInterval);
  StepSeries series;
  double integral = 0, last = 0;
  for (const double t : {0.0, 4e-6, 20e-6, 41e-6, 58e-6, 95e-6, 96e-6}) {
    series.add(hill(t), clock.advance(t));
    const double h = t - last, bow = -1 / (10e-6 * 10e-6);
    const bool outermost = last == 0 || t == 96e-6;
    integral += h / 2 * (hill(last) + hill(t)) - (outermost ? 0.5 : 1) * h * h * h / 6 * bow;
    last = t;
  }
  EXPECT_NEAR(series.mean(), integral / 96e-6, 1e-12);
  EXPECT_NEAR(series.peak(), 19.01, 1e-12);  // |-19.01| at the start, no top
  StepClock again(41e-6, kInterval);
  StepSeries near;
  for (const double t : {41e-6, 48e-6, 58e-6}) near.add(hill(t), again.advance(t));
  EXPECT_NEAR(near.peak(), 7, 1e-12);
}

TEST(StepSeries, SquaresOfAWaveAreRightToTheFourthOrder) {
  constexpr double rate = 1e5;
  const auto error = [](double longest) {
    StepClock clock(0, kInterval);
    StepSeries wave;
    double t = 0, end = 0;
    for (int k = 0; t < 2e-3; ++k, t += longest * (k % 3 == 0 ? 0.4 : 1)) {
      wave.add(std::sin(rate * t), clock.advance(t));
      end = t;
    }
    const double exact = 0.5 - std::sin(2 * rate * end) / (4 * rate * end);
    return std::abs(wave.rms() * wave.rms() / exact - 1);
  };
  EXPECT_LT(error(6e-6), 2e-5);
  EXPECT_LT(error(3e-6), error(6e-6) / 4);
}

// A contact begins behind a long step, and steps grow with its age: the parabola across its start
// says nothing of the long step.
TEST(StepSeries, AContactThatBeginsIsNoBowOfTheStepBeforeIt) {
  constexpr double kTouch = 100e-6, kRise = 20e-6, kAge = 64e-6;
  const auto force = [](double t) { return t > kTouch ? -std::expm1((kTouch - t) / kRise) : 0.0; };
  StepClock clock(0, kInterval);
  StepSeries series;
  const auto see = [&](double t) { series.add(force(t), clock.advance(t)); };
  for (int k = 0; k < 8; ++k) see(k * 12e-6);
  for (const double age : {-0.1, 0.5, 2.5, 8.0, 16.0, 24.0, 32.0, 40.0, 48.0, 56.0, 64.0})
    see(kTouch + 1e-6 * age);
  const double gone = -std::expm1(-kAge / kRise), rest = gone * (2 - gone) / 2;
  const double mean = (kAge - kRise * gone) / (kTouch + kAge);
  const double square = (kAge - 2 * kRise * gone + kRise * rest) / (kTouch + kAge);
  EXPECT_NEAR(series.mean(), mean, 0.001 * mean);
  EXPECT_NEAR(series.rms() * series.rms(), square, 0.001 * square);
}

TEST(StepClock, LeavesEachInstantOfTheRecordToTheStateNearestToIt) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<double> times = uneven_times(seed);
    StepClock clock(times.front(), kInterval);
    std::vector<int> recorded(times.size(), 0), nearest(times.size(), 0);
    for (std::size_t i = 0; i < times.size(); ++i) {
      const SeenStep step = clock.advance(times[i]);
      EXPECT_NEAR(step.length, i > 0 ? times[i] - times[i - 1] : 0, 1e-15);
      if (i > 0) recorded[i - 1] += step.recorded_at_start;
      recorded[i] += step.recorded_at_end;
    }
    for (double at = times.front(); at <= times.back(); at += kInterval) {
      std::size_t best = 0;
      for (std::size_t i = 1; i < times.size(); ++i)
        if (std::abs(times[i] - at) < std::abs(times[best] - at)) best = i;
      ++nearest[best];
    }
    EXPECT_EQ(recorded, nearest) << seed;
  }
}

TEST(RollerSeries, IsOneStepSeriesOfEveryRoller) {
  std::mt19937 random(1);
  std::normal_distribution<double> value(5, 1);
  constexpr int kRollers = 11;  // of two packs
  const std::vector<double> times = uneven_times(7);
  StepClock clock(times.front(), kInterval);
  RollerSeries packs;
  std::vector<StepSeries> rollers(kRollers);
  Series recorded;
  std::vector<double> last(kRollers);
  for (const double t : times) {
    const SeenStep step = clock.advance(t);
    for (std::size_t pack = 0; pack < 2; ++pack) {
      Pack values;
      Mask counts{};
      for (int lane = 0; lane < kLanes; ++lane) {
        values[lane] = value(random);
        const std::size_t roller = pack * kLanes + static_cast<std::size_t>(lane);
        if (roller >= kRollers) continue;
        counts[lane] = -1;
        rollers[roller].add(values[lane], step);
        recorded.add(last[roller], 0, step.recorded_at_start);
        recorded.add(values[lane], 0, step.recorded_at_end);
        last[roller] = values[lane];
      }
      packs.add(pack, values, counts, step);
    }
  }
  double mean = 0, square = 0, peak = 0;
  for (const StepSeries& roller : rollers) {
    mean += roller.mean() / kRollers;
    square += roller.rms() * roller.rms() / kRollers;
    peak = std::max(peak, roller.peak());
  }
  const Series all = packs.all();
  EXPECT_NEAR(all.mean(), mean, 1e-12);
  EXPECT_NEAR(all.rms(), std::sqrt(square), 1e-12);
  EXPECT_NEAR(all.standard_deviation(), std::sqrt(square - mean * mean), 1e-12);
  EXPECT_NEAR(all.peak(), peak, 1e-12);
  for (const double p : {0.1, 0.5, 0.95}) EXPECT_EQ(all.quantile(p), recorded.quantile(p));
}

// A roller's quantity that exists in stretches only: what it is elsewhere does not matter.
TEST(RollerSeries, LeavesOutWhatDoesNotCount) {
  const std::vector<double> times = uneven_times(5);
  StepClock clock(times.front(), kInterval);
  RollerSeries slip;
  for (std::size_t i = 0; i < times.size(); ++i) {
    Pack values = splat(2.0);
    Mask counts{};
    counts[5] = i % 7 < 4 ? -1 : 0;
    if (!counts[5]) values[5] = 1e3;
    slip.add(0, values, counts, clock.advance(times[i]));
  }
  EXPECT_NEAR(slip.all().mean(), 2, 1e-12);
  EXPECT_NEAR(slip.all().standard_deviation(), 0, 1e-6);
  EXPECT_EQ(slip.all().peak(), 2);
  EXPECT_EQ(slip.all().quantile(1), 2);
}

TEST(RollerSeries, NothingThatCountsIsNoNumber) {
  RollerSeries slip;
  StepClock clock(0, kInterval);
  for (const double t : {0.0, 1e-5}) slip.add(0, splat(1.0), Mask{}, clock.advance(t));
  EXPECT_TRUE(std::isnan(slip.all().mean()));
  EXPECT_TRUE(std::isnan(slip.all().peak()));
  EXPECT_TRUE(std::isnan(slip.all().quantile(0.5)));
}

}  // namespace
}  // namespace cagetol
