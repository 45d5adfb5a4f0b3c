#include "analysis/tolerance/screen.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/study/refused.hpp"
#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kRows = 32, kRuns = 40, kPockets = 13;
constexpr double kLot = 0.03, kPocket = 0.02, kLoad = 50;  // sigmas
constexpr double kWidthSlope = 3, kWidthSquare = 20, kWidthScatter = 2, kLengthSlope = -1,
                 kLoadSlope = 0.001;

ScreenDimension dimension(const std::string& key, double pocket_sigma) {
  return {.key = key,
          .hundredth = 0.01,
          .width_mm = 0.4,
          .narrowest_mm = 0.04,
          .lot_sigma = kLot,
          .pocket_sigma = pocket_sigma,
          .jams = {key, {0.02, 0.5, 0.6, 1}, {0, 1e-6, 0.1, 0.9}}};
}

/// Widths move y by lot, its square and scatter, lengths by their lot alone, the load too.
StudyData standin(std::uint64_t seed, double cage_noise, double start_noise, double limit) {
  StudyData study = plain_study(kRuns);
  study.pockets = kPockets;
  study.plan.target_yield = 0.95;
  study.plan.confidence = 0.95;
  study.plan.limits = {{"y", {}, limit, "stand-in", 1}};
  InputColumns width{"width", "mm", {7.65}, {}, {}, {}, {}, true},
      length{"length", "mm", {9.25}, {}, {}, {}, {}, false},
      load{"load.radial_N", "N", {1000}, {}, {}, {}, {}, false};
  Column y{"y", "-", "", {}};
  for (std::size_t i = 0; i < kRuns; ++i) {
    const std::size_t row = i % kRows;
    study.row[i] = static_cast<std::int64_t>(row);
    study.replicate[i] = static_cast<std::int64_t>(i / kRows);
    RandomStream cage(seed, Purpose::lot, row, 0), start(seed, Purpose::noise, i, 0);
    const auto normal = [](RandomStream& stream) { return gsl_cdf_ugaussian_Pinv(stream.next()); };
    width.lot.push_back(kLot * normal(cage));
    length.lot.push_back(kLot * normal(cage));
    // As a Latin hypercube fills its law.
    load.lot.push_back(kLoad *
                       gsl_cdf_ugaussian_Pinv(
                           (static_cast<double>((13 * row + seed) % kRows) + cage.next()) / kRows));
    double mean = 0, square = 0;
    for (std::size_t j = 0; j < kPockets; ++j) {
      const double deviation = width.lot.back() + (row % 2 == 0 ? 0 : kPocket * normal(cage));
      width.value.push_back(7.65 + deviation);
      mean += deviation / kPockets;
      square += deviation * deviation / (kPockets - 1);
    }
    const double scatter = std::sqrt(std::max(0.0, square - kPockets / 12.0 * mean * mean));
    length.value.push_back(9.25 + length.lot.back());
    load.value.push_back(1000 + load.lot.back());
    y.values.push_back(1 + kWidthSlope * mean + kWidthSquare * mean * mean +
                       kWidthScatter * scatter + kLengthSlope * length.lot.back() +
                       kLoadSlope * load.lot.back() + cage_noise * normal(cage) +
                       start_noise * normal(start));
  }
  study.inputs = {width, length, load};
  study.quantities = {y};
  return study;
}

const std::vector<ScreenDimension> kBoth = {dimension("width", kPocket), dimension("length", 0)};

/// Share of cages beyond the limit with widths of so many mm, by the same sum.
double margin(double width_mm, double length_mm, double rest, double limit) {
  const double w = width_mm / 0.4, l = length_mm / 0.4,
               v = w * w * (kLot * kLot + kPocket * kPocket / kPockets);
  const double mean = 1 + kWidthScatter * w * kPocket + kWidthSquare * v,
               variance = kWidthSlope * kWidthSlope * v + 2 * std::pow(kWidthSquare * v, 2) +
                          std::pow(kLengthSlope * l * kLot, 2) + std::pow(kLoadSlope * kLoad, 2) +
                          rest;
  return (limit - mean) / std::sqrt(variance);
}

TEST(Screen, IntervalsHoldWhatMovesAStandIn) {
  constexpr int repeats = 400;
  constexpr double cage_noise = 0.02, start_noise = 0.03, limit = 1.2;
  const double rest = cage_noise * cage_noise + start_noise * start_noise;
  double reached = 0;
  while (margin(reached, 0.04, rest, limit) > gsl_cdf_ugaussian_Pinv(0.95)) reached += 1e-4;
  int lot = 0, pocket = 0, other = 0, width = 0;
  double noise = 0;
  for (int seed = 0; seed < repeats; ++seed) {
    const Screen screen = screen_limits(
        standin(static_cast<std::uint64_t>(seed), cage_noise, start_noise, limit), kBoth, 0.001);
    const ScreenedLimit& found = screen.limits[0];
    ASSERT_EQ(found.parts.size(), 3u);
    const auto holds = [&](std::size_t part, double truth) {
      return std::abs(found.parts[part].shift - 0.01 * truth) <= 2.07 * found.parts[part].error;
    };
    lot += holds(0, kWidthSlope);
    pocket += holds(1, kWidthScatter);
    other += holds(2, kLengthSlope);
    const LimitReach& reach = found.reach[0];
    width += reach.lower_mm && *reach.lower_mm <= reached && reached <= reach.upper_mm.value_or(9);
    noise += found.start_noise * found.start_noise / repeats;
    EXPECT_FALSE(screen.jams_alone);
    EXPECT_NEAR(reach.jam_mm.value_or(0), 0.595, 0.01);
  }
  EXPECT_NEAR(std::sqrt(noise), start_noise, 0.002);
  // 95 % of 400 are 380 +- 4.4.
  SCOPED_TRACE(testing::PrintToString(std::vector<int>{lot, pocket, other, width}));
  for (const int held : {lot, pocket, other, width}) {
    EXPECT_GT(held, 364);
    EXPECT_LT(held, 398);
  }
}

// Also where the runs are so few that a deviation may be none.
TEST(Screen, AnIntervalHoldsItsEstimate) {
  const auto place = [](const std::optional<double>& width) { return width.value_or(HUGE_VAL); };
  for (std::uint64_t seed = 0; seed < 300; ++seed)
    for (const double limit : {1.1, 1.25, 1.5}) {
      const Screen screen = screen_limits(standin(seed, 0.05, 0.02, limit), kBoth, 0.001);
      for (const LimitReach& reach : screen.limits[0].reach) {
        EXPECT_LE(place(reach.lower_mm), place(reach.width_mm)) << seed << ", " << limit;
        EXPECT_GE(place(reach.upper_mm), place(reach.width_mm)) << seed << ", " << limit;
      }
    }
}

/// The runs with a dimension of these middles at the width screened; deviations as they are, so that
/// a quantity that follows them about the nominal value has its slope there.
TEST(Screen, AZoneKeepsItsFormAsItsWidthChanges) {
  constexpr double kMiddle = 0.1;
  StudyData study = standin(3, 1e-4, 1e-4, 2.5);
  for (double& value : study.inputs[0].value) value += kMiddle;
  auto zoned = kBoth;
  zoned[0].middle = kMiddle;
  const Screen screen = screen_limits(study, zoned, 0.001);
  // y = 1 + 3 u + 20 u^2 about the middle screened, where the level is that of a cage in it.
  EXPECT_NEAR(screen.limits[0].level, 1, 0.01);
  EXPECT_NEAR(screen.limits[0].parts[0].shift, 0.01 * kWidthSlope, 1e-3);
  // Mean and variance at a width w: u lies about (w/0.4 - 1) 0.1 with the deviation of that width.
  const auto z = [&](double width_mm) {
    const double w = width_mm / 0.4, l = 0.1, m = (w - 1) * kMiddle,
                 v = w * w * (kLot * kLot + kPocket * kPocket / kPockets);
    const double mean =
                     1 + kWidthSlope * m + kWidthSquare * (v + m * m) + kWidthScatter * w * kPocket,
                 slope = kWidthSlope + 2 * kWidthSquare * m,
                 variance = slope * slope * v + 2 * kWidthSquare * kWidthSquare * v * v +
                            kLengthSlope * kLengthSlope * l * l * kLot * kLot +
                            kLoadSlope * kLoadSlope * kLoad * kLoad;
    return (2.5 - mean) / std::sqrt(variance);
  };
  double reached = 0.2;
  while (z(reached) > gsl_cdf_ugaussian_Pinv(0.95)) reached += 1e-4;
  ASSERT_TRUE(screen.limits[0].reach[0].width_mm);
  EXPECT_NEAR(*screen.limits[0].reach[0].width_mm, reached, 0.02);
  EXPECT_GT(std::abs(*screen_limits(study, kBoth, 0.001).limits[0].reach[0].width_mm - reached),
            0.05);
}

TEST(Screen, SaysWhatIsNotResolvedAndWhatJamsDecide) {
  const Screen far = screen_limits(standin(1, 0.02, 0.03, 9), kBoth, 0.001);
  EXPECT_TRUE(far.jams_alone);
  EXPECT_FALSE(far.limits[0].reach[0].width_mm);
  for (const PartShift& part : far.limits[0].parts) EXPECT_TRUE(part.resolved);
  // Jams leave nothing of the target: as much would be missed.
  EXPECT_FALSE(screen_limits(standin(1, 0.02, 0.03, 9), kBoth, 0.06).jams_alone);
  const Screen noisy = screen_limits(standin(1, 0.2, 0.3, 1.2), kBoth, 0.001);
  EXPECT_FALSE(noisy.limits[0].parts[1].resolved);
  StudyData lost = standin(1, 0.02, 0.03, 9);
  for (std::size_t i = 3; i < lost.size(); ++i) lost.status[i] = RunStatus::failed;
  EXPECT_THROW(screen_limits(lost, kBoth, 0), Refused);
}

TEST(Screen, LimitsAndJamsTakeFromTheTargetTogether) {
  StudyData runs = standin(3, 0.02, 0.03, 1.2);
  const Screen one = screen_limits(runs, kBoth, 0.001);
  // Few jam where the limit is reached; the width is that of the limit alone.
  EXPECT_EQ(one.together[0].width_mm, one.limits[0].reach[0].width_mm);
  EXPECT_EQ(one.together[0].lower_mm, one.limits[0].reach[0].lower_mm);
  // The same limit once more takes as much again: each has half of the target's misses.
  runs.quantities.push_back(runs.quantities[0]);
  runs.quantities.back().name = "again";
  runs.plan.limits.push_back({"again", {}, 1.2, "stand-in", 1});
  const Screen two = screen_limits(runs, kBoth, 0.001);
  runs.plan.limits.pop_back();
  runs.plan.target_yield = 0.975;
  EXPECT_EQ(two.together[0].width_mm,
            screen_limits(runs, kBoth, 0.001).limits[0].reach[0].width_mm);
  EXPECT_LT(two.together[0].width_mm, one.together[0].width_mm);
  // A limit that is never reached leaves jams, to a step of the search.
  runs.plan.limits[0].maximum = 9;
  const Screen jams = screen_limits(runs, kBoth, 0.001);
  EXPECT_NEAR(jams.together[0].width_mm.value_or(0), *jams.together[0].jam_mm, 0.003);
  EXPECT_EQ(jams.together[0].lower_mm, jams.together[0].upper_mm);
}

// Of six cages nobody knows the scatter well; a hundred standard deviations are still far.
TEST(Screen, ALimitFarAwayStaysFarHoweverFewTheRuns) {
  StudyData runs = standin(4, 0.02, 0.03, 9);
  for (std::size_t i = 6; i < runs.size(); ++i) runs.status[i] = RunStatus::failed;
  const LimitReach far = screen_limits(runs, kBoth, 0.001).limits[0].reach[0];
  EXPECT_FALSE(far.lower_mm) << far.lower_mm.value_or(0);
  runs.plan.limits[0].maximum = 1.2;
  EXPECT_EQ(screen_limits(runs, kBoth, 0.001).limits[0].reach[0].lower_mm, 0);
}

TEST(Screen, AMinimumIsReachedFromAbove) {
  StudyData runs = standin(2, 0.02, 0.03, 1.3);
  const Screen above = screen_limits(runs, kBoth, 0.001);
  for (double& value : runs.quantities[0].values) value = -value;
  runs.plan.limits = {{"y", -1.3, {}, "stand-in", 1}};
  const Screen below = screen_limits(runs, kBoth, 0.001);
  EXPECT_FALSE(below.limits[0].is_maximum);
  EXPECT_DOUBLE_EQ(below.limits[0].parts[0].shift, -above.limits[0].parts[0].shift);
  EXPECT_EQ(below.limits[0].reach[0].width_mm, above.limits[0].reach[0].width_mm);
}

}  // namespace
}  // namespace cagetol
