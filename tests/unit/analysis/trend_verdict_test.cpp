#include "analysis/response/trend_verdict.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cagetol {
namespace {

using testing::HasSubstr;

PairedDifference seen(double lower, double upper, double first_mean = 10) {
  PairedDifference d;
  d.pairs = 16;
  d.difference = {0.5 * (lower + upper), lower, upper};
  d.first_mean = first_mean;
  d.second_mean = first_mean + d.difference.value;
  return d;
}

Trend claim(const std::string& expected, double by_share = 0, double by_value = 0) {
  Trend trend;
  trend.expected = expected;
  trend.by_share = by_share;
  trend.by_value = by_value;
  return trend;
}

TrendVerdict verdict(const Trend& trend, const PairedDifference& d) {
  return judge_trend(trend, d).verdict;
}

TEST(TrendVerdict, DirectionNeedsTheWholeIntervalOnOneSide) {
  EXPECT_EQ(verdict(claim("rises"), seen(0.1, 2)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("rises"), seen(-0.1, 2)), TrendVerdict::undecided);
  EXPECT_EQ(verdict(claim("rises"), seen(-2, -0.1)), TrendVerdict::disagrees);
  EXPECT_EQ(verdict(claim("falls"), seen(-2, -0.1)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("falls"), seen(-2, 0.1)), TrendVerdict::undecided);
  EXPECT_EQ(verdict(claim("falls"), seen(0.1, 2)), TrendVerdict::disagrees);
}

TEST(TrendVerdict, FarAboveNeedsTheChangeClaimedNotJustItsSign) {
  EXPECT_EQ(verdict(claim("rises", 1), seen(11, 14)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("rises", 1), seen(9, 14)), TrendVerdict::undecided);
  EXPECT_EQ(verdict(claim("rises", 1), seen(1, 2)), TrendVerdict::disagrees);
  EXPECT_THAT(judge_trend(claim("rises", 1), seen(1, 2)).reason,
              HasSubstr("it rises, but by less than claimed"));
  EXPECT_EQ(verdict(claim("rises", 1), seen(11, 14, -10)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("falls", 0, 3), seen(-5, -4)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("falls", 0, 3), seen(-2, -1)), TrendVerdict::disagrees);
}

TEST(TrendVerdict, LevelNeedsTheWholeIntervalInsideWhatCountsAsNone) {
  EXPECT_EQ(verdict(claim("level", 0.05), seen(-0.4, 0.4)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("level", 0.05), seen(0.1, 0.4)), TrendVerdict::agrees);
  EXPECT_EQ(verdict(claim("level", 0.05), seen(-0.4, 0.6)), TrendVerdict::undecided);
  EXPECT_EQ(verdict(claim("level", 0.05), seen(0.6, 0.9)), TrendVerdict::disagrees);
  EXPECT_EQ(verdict(claim("level", 0.05), seen(-0.9, -0.6)), TrendVerdict::disagrees);
}

TEST(TrendVerdict, RunsThatAgreeToTheBitContradictAnyChange) {
  PairedDifference same = seen(0, 0);
  same.identical = true;
  EXPECT_EQ(verdict(claim("falls"), same), TrendVerdict::disagrees);
  EXPECT_EQ(verdict(claim("level", 0.05), same), TrendVerdict::agrees);
  EXPECT_THAT(judge_trend(claim("rises"), same).reason, HasSubstr("identical to the bit"));
}

TEST(TrendVerdict, WithoutAClaimOrWithoutValuesThereIsNoAgreement) {
  EXPECT_EQ(verdict(claim("unclear"), seen(1, 2)), TrendVerdict::no_claim);
  EXPECT_EQ(judge_trend(claim("unclear"), seen(1, 2)).reason, "it rises");
  EXPECT_EQ(verdict(claim("rises"), PairedDifference{}), TrendVerdict::no_values);
  PairedDifference single = seen(0, 0);
  single.pairs = 1;
  EXPECT_EQ(verdict(claim("rises"), single), TrendVerdict::undecided);
}

}  // namespace
}  // namespace cagetol
