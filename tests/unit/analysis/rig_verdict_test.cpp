#include "analysis/compare/rig_verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<double> kSlips{0.01, 0.02, 0.03, kUndefined};  // mean 0.02, s 0.01
// Two degrees of freedom: t at 97.5 % is 4.3027.
const double kHalf = 4.302653 * 0.01 * std::sqrt(4.0 / 3);

TEST(RigVerdict, IntervalOverStartsByHand) {
  const RigVerdict verdict = hold_against(0.06, kSlips, {});
  EXPECT_EQ(verdict.runs, 3U);
  EXPECT_DOUBLE_EQ(verdict.starts.value, 0.02);
  EXPECT_NEAR(verdict.starts.upper, 0.02 + kHalf, 1e-8);
  EXPECT_NEAR(verdict.all.lower, 0.02 - kHalf, 1e-8);
  EXPECT_TRUE(verdict.within_starts);
  EXPECT_FALSE(hold_against(0.08, kSlips, {}).within_all);
  EXPECT_TRUE(std::isnan(hold_against(0.01, {0.01, kUndefined}, {}).starts.lower));
}

TEST(RigVerdict, ShiftsOfAssumptionsAddAsVariances) {
  // Two assumptions raise the slip by 0.3 and 0.4, one of them by 0.1 at its other end, too; the
  // second lowers it by 0.2. The shift of the last is scatter alone: +-0.01 about 0.
  const std::vector<AssumedSlips> ends = {{"a", {0.31, 0.32, 0.33}},
                                          {"a", {0.11, 0.12, 0.13}},
                                          {"b", {0.41, 0.42, 0.43}},
                                          {"b", {-0.19, -0.18, -0.17}},
                                          {"c", {0.02, 0.02, 0.02}}};
  const RigVerdict verdict = hold_against(0.45, kSlips, ends);
  EXPECT_NEAR(verdict.shifts[0], 0.3, 1e-12);
  EXPECT_NEAR(verdict.all.upper, 0.02 + std::sqrt(kHalf * kHalf + 0.3 * 0.3 + 0.4 * 0.4), 1e-7);
  EXPECT_NEAR(verdict.all.lower, 0.02 - std::sqrt(kHalf * kHalf + 0.2 * 0.2), 1e-7);
  EXPECT_TRUE(verdict.within_all && !verdict.within_starts);
  EXPECT_THAT(verdict.covering, ElementsAre(2));  // of b = 1; that of a = 1 ends at 0.32 + h
  EXPECT_EQ(verdict.nearest, 2);
  EXPECT_THAT(hold_against(0.3, kSlips, ends).covering, ElementsAre(0, 2));
  EXPECT_EQ(hold_against(0.3, kSlips, ends).nearest, 0);
  EXPECT_THAT(hold_against(0.99, kSlips, ends).covering, IsEmpty());
  EXPECT_FALSE(hold_against(0.99, kSlips, ends).within_all);
  EXPECT_EQ(hold_against(-0.9, kSlips, {{"c", {0.02, 0.02, 0.02}}}).nearest, -1);
}

TEST(RigVerdict, SaysWhereAMeasurementSettlesMore) {
  const std::vector<double> sure{0.0199, 0.02, 0.0201};
  const auto raised_by = [&](double shift) {
    return hold_against(0.02, sure, {{"a", {sure[0] + shift, sure[1] + shift, sure[2] + shift}}});
  };
  EXPECT_FALSE(raised_by(0.03).is_wide);
  EXPECT_TRUE(raised_by(0.05).is_wide);
  EXPECT_DOUBLE_EQ(raised_by(1.5).all.upper, 1);  // a cage that stands
}

TEST(RigVerdict, OneMoreRunLiesInTheIntervalOverStarts) {
  std::mt19937 random(1);
  std::normal_distribution<double> slip(0.02, 0.003);
  int within = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<double> starts(6);
    for (double& start : starts) start = slip(random);
    within += hold_against(slip(random), starts, {}).within_starts;
  }
  EXPECT_NEAR(within / 2000.0, 0.95, 0.015);
}

}  // namespace
}  // namespace cagetol
