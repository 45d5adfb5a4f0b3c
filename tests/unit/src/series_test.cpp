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

TEST(Series, IntegralsDoNotDependOnTheFirstValue) {
  Series series;
  for (const double x : {7.0, 9.0, 2.0}) series.add(x, 0.5);
  EXPECT_DOUBLE_EQ(series.sums().integral(), 9);
}

// Parabolas and their tops: exact but for the first and the last step, which see half of the bow.
TEST(StepSeries, FollowsParabolasThroughNeighbouringStates) {
  const auto hill = [](double t) { return 7 - std::pow((t - 51e-6) / 10e-6, 2); };
  StepClock clock(0, kInterval);
  StepSeries series(kPeak);
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
  StepSeries near(kPeak);
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

// Instants between states are read off the parabola through three of them: exact for a parabola
// but in the first step, of which only the chord is known.
TEST(StepSeries, RecordsWhatItAmountsToAtEachInstant) {
  const auto hill = [](double t) { return 7 - std::pow((t - 3.05e-3) / 1e-3, 2); };
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<double> times = uneven_times(seed);
    StepClock clock(times.front(), kInterval);
    StepSeries series(kQuantiles);
    for (const double t : times) series.add(hill(t), clock.advance(t));
    Series exact;
    for (int k = 0; times.front() + k * kInterval <= times.back(); ++k) {
      const double at = times.front() + k * kInterval,
                   share = (at - times[0]) / (times[1] - times[0]);
      exact.add(
          at < times[1] ? hill(times[0]) + share * (hill(times[1]) - hill(times[0])) : hill(at), 1,
          1);
    }
    for (const double p : {0.0, 0.1, 0.5, 0.99, 1.0})
      EXPECT_NEAR(series.quantile(p), exact.quantile(p), 1e-9) << seed << ", " << p;
  }
}

TEST(StepClock, FindsEveryInstantOfTheRecord) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<double> times = uneven_times(seed);
    StepClock clock(times.front(), kInterval);
    int instants = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const SeenStep step = clock.advance(times[i]);
      EXPECT_NEAR(step.length, i > 0 ? times[i] - times[i - 1] : 0, 1e-15);
      for (int k = step.instants - 1; k >= 0; --k)
        EXPECT_NEAR(times[i] - step.last_instant - k * step.interval,
                    times.front() + instants++ * kInterval, 1e-12);
    }
    EXPECT_EQ(instants, 1 + static_cast<int>((times.back() - times.front()) / kInterval));
  }
}

// An acceleration that rings at one radian a step, with its integrals: trapeziums miss 8 % of the
// square (the parabolas 0.27 %).
TEST(PlaneAcceleration, FollowsAWaveThatStatesSample) {
  constexpr double rate = 1e5, h = 1e-5;
  StepClock clock(0, kInterval);
  PlaneAcceleration turning, swinging;
  for (int k = 0; k <= 628; ++k) {
    const double phase = rate * h * k, c = std::cos(phase), s = std::sin(phase);
    const double v = 1 / rate, x = 1 / (rate * rate);
    const SeenStep step = clock.advance(h * k);
    turning.add({2 * c, 2 * s}, {2 * s * v, -2 * c * v}, {-2 * c * x, -2 * s * x}, step);
    swinging.add({0, c}, {0, s * v}, {0, -c * x}, step);
  }
  EXPECT_NEAR(turning.rms() * turning.rms(), 4, 0.003 * 4);
  EXPECT_NEAR(turning.peak(), 2, 1e-3);
  EXPECT_NEAR(swinging.rms() * swinging.rms(), 0.5, 0.004 * 0.5);
  EXPECT_NEAR(swinging.peak(), 1, 1e-3);
}

TEST(PlaneAcceleration, PeaksBetweenStates) {
  // One step; no state lies nearer to a peak than half of it.
  constexpr double turn = std::numbers::pi / 3;
  StepClock clock(0, kInterval);
  PlaneAcceleration swinging;
  for (int k = 0; k < 12; ++k) {
    const double phase = turn * (k + 0.5), c = std::cos(phase), s = std::sin(phase);
    swinging.add({c, 0}, {s, 0}, {-c, 0}, clock.advance(phase));
    EXPECT_LT(std::abs(c), 0.867);
  }
  EXPECT_NEAR(swinging.peak(), 1, 1e-3);
}

// The last step of a window may be as short as rounding leaves it: the places at its ends then tell
// nothing of the acceleration between them.
TEST(PlaneAcceleration, IsNotMadeOfRounding) {
  StepClock clock(0, kInterval);
  PlaneAcceleration falling;
  const auto see = [&](double t) {
    falling.add({10, 0}, {10 * t, 0}, {20e-6 + 5 * t * t, 0}, clock.advance(t));
  };
  double t = 4e-3;
  for (int k = 0; k < 10; ++k, t += 1e-5) see(t);
  for (int k = 0; k < 10; ++k) see(t = std::nextafter(t, 1.0));
  EXPECT_NEAR(falling.peak(), 10, 1e-3);
}

TEST(PlaneAcceleration, IsExactForParabolasItsPeakForCubics) {
  StepClock clock(0, kInterval), again(0, kInterval);
  PlaneAcceleration parabola, cubic;
  for (const double t : {0.0, 0.3, 1.0})
    parabola.add({0, t * (1 - t)}, {0, t * t / 2 - t * t * t / 3},
                 {0, t * t * t / 6 - t * t * t * t / 12}, again.advance(t));
  EXPECT_NEAR(parabola.rms(), std::sqrt(1.0 / 30), 1e-15);
  for (const double t : {0.0, 0.3, 1.0}) {
    const double t2 = t * t, t3 = t2 * t, t4 = t3 * t, t5 = t4 * t;
    cubic.add({0, t - 3 * t2 + 2 * t3}, {0, t2 / 2 - t3 + t4 / 2}, {0, t3 / 6 - t4 / 4 + t5 / 10},
              clock.advance(t));
  }
  EXPECT_NEAR(cubic.peak(), 1 / (6 * std::sqrt(3.0)), 1e-3);
}

TEST(RollerSeries, IsOneStepSeriesOfEveryRoller) {
  std::mt19937 random(1);
  std::normal_distribution<double> value(5, 1);
  constexpr int kFollowed = 11, kPacks = (kFollowed + kLanes - 1) / kLanes;  // the last not whole
  const std::vector<double> times = uneven_times(7);
  StepClock clock(times.front(), kInterval);
  RollerSeries packs(kPeak | kQuantiles);
  std::vector<StepSeries> rollers(kFollowed, StepSeries(kPeak | kQuantiles));
  for (const double t : times) {
    const SeenStep step = clock.advance(t);
    for (std::size_t pack = 0; pack < kPacks; ++pack) {
      Pack values;
      Mask counts{};
      for (int lane = 0; lane < kLanes; ++lane) {
        values[lane] = value(random);
        const std::size_t roller = pack * kLanes + static_cast<std::size_t>(lane);
        if (roller >= kFollowed) continue;
        counts[lane] = -1;
        rollers[roller].add(values[lane], step);
      }
      packs.add(pack, values, counts, step);
    }
  }
  double mean = 0, square = 0, peak = 0;
  for (const StepSeries& roller : rollers) {
    mean += roller.mean() / kFollowed;
    square += roller.rms() * roller.rms() / kFollowed;
    peak = std::max(peak, roller.peak());
  }
  const Series all = packs.all();
  EXPECT_NEAR(all.mean(), mean, 1e-12);
  EXPECT_NEAR(all.rms(), std::sqrt(square), 1e-12);
  EXPECT_NEAR(all.standard_deviation(), std::sqrt(square - mean * mean), 1e-12);
  EXPECT_NEAR(all.peak(), peak, 1e-12);
  double most = 0;
  for (const StepSeries& roller : rollers) most = std::max(most, roller.quantile(1));
  EXPECT_NEAR(all.quantile(1), most, 1e-12);
}

// A roller's quantity that exists in stretches only: what it is elsewhere does not matter.
TEST(RollerSeries, LeavesOutWhatDoesNotCount) {
  const std::vector<double> times = uneven_times(5);
  StepClock clock(times.front(), kInterval);
  RollerSeries slip(kPeak | kQuantiles);
  for (std::size_t i = 0; i < times.size(); ++i) {
    Pack values = splat(2.0);
    Mask counts{};
    counts[2] = i % 7 < 4 ? -1 : 0;
    if (!counts[2]) values[2] = 1e3;
    slip.add(0, values, counts, clock.advance(times[i]));
  }
  EXPECT_NEAR(slip.all().mean(), 2, 1e-12);
  EXPECT_NEAR(slip.all().standard_deviation(), 0, 1e-6);
  EXPECT_EQ(slip.all().peak(), 2);
  EXPECT_EQ(slip.all().quantile(1), 2);
}

// The gate crosses the threshold between states, where the value is on its way from one to another.
TEST(RollerSeries, IsLargestWhereItsGateOpensOrCloses) {
  const auto peak = [](std::pair<double, double> gates, std::pair<double, double> values) {
    StepClock clock(0, kInterval);
    RollerSeries sliding(kPeak);
    Mask here{};
    here[1] = -1;
    sliding.add_above(0, splat(values.first), splat(gates.first), 1, here, clock.advance(0));
    sliding.add_above(0, splat(values.second), splat(gates.second), 1, here, clock.advance(1e-5));
    return sliding.all().peak();
  };
  EXPECT_NEAR(peak({0.5, 2.5}, {-9, -3}), 7.5, 1e-12);  // opens a quarter into the step,
  EXPECT_NEAR(peak({2.5, 0.5}, {3, 9}), 7.5, 1e-12);    // closes as long before its end
  EXPECT_EQ(peak({0.5, 2.5}, {3, 9}), 9);
  EXPECT_EQ(peak({2, 2.5}, {3, 4}), 4);  // open all along
  // Where there was no contact it had no value that a chord could start from.
  EXPECT_EQ(peak({0, 2.5}, {9, 3}), 3);
}

TEST(StepSeries, WhatIsNotAskedIsNoNumber) {
  StepClock clock(0, kInterval), again(0, kInterval);
  StepSeries step;
  RollerSeries rollers;
  Mask counts{};
  counts[0] = -1;
  for (const double t : {0.0, 4e-6, 50e-6}) {
    step.add(t, clock.advance(t));
    rollers.add(0, splat(t), counts, again.advance(t));
  }
  EXPECT_NEAR(rollers.all().mean(), step.mean(), 1e-20);
  for (const Series& series : {static_cast<const Series&>(step), rollers.all()}) {
    EXPECT_TRUE(std::isnan(series.peak()));
    EXPECT_TRUE(std::isnan(series.quantile(0.5)));
  }
}

TEST(RollerSeries, NothingThatCountsIsNoNumber) {
  RollerSeries slip(kPeak | kQuantiles);
  StepClock clock(0, kInterval);
  for (const double t : {0.0, 1e-5}) slip.add(0, splat(1.0), Mask{}, clock.advance(t));
  EXPECT_TRUE(std::isnan(slip.all().mean()));
  EXPECT_TRUE(std::isnan(slip.all().peak()));
  EXPECT_TRUE(std::isnan(slip.all().quantile(0.5)));
}

}  // namespace
}  // namespace cagetol
