// What limits do, on runs whose misses are counted by hand.
#include "analysis/tolerance/limit_margin.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

/// Quantity "a" is 1, 2, ..., n in n runs; "b" half of it.
StudyData counted_runs(std::int64_t n, std::vector<Limit> limits) {
  StudyData runs = plain_study(n);
  Column a{"a", "N", "counts", {}}, b{"b", "N", "counts by halves", {}};
  for (std::int64_t i = 1; i <= n; ++i) {
    a.values.push_back(static_cast<double>(i));
    b.values.push_back(static_cast<double>(i) / 2);
  }
  runs.quantities = {a, b};
  runs.plan.limits = std::move(limits);
  runs.plan.target_yield = runs.plan.confidence = 0.95;
  return runs;
}

Limit at_most(const std::string& quantity, double most) {
  Limit limit{.quantity = quantity};
  limit.maximum = most;
  return limit;
}

TEST(LimitMargins, AreDistancesInUnitsOfTheBound) {
  Limit both = at_most("a", 200);
  both.minimum = -50;
  Limit minimum{.quantity = "a"};
  minimum.minimum = 40;
  const auto m = limit_margins(counted_runs(101, {both, minimum, at_most("a", 0)}));
  EXPECT_DOUBLE_EQ(m[0].median, 51);
  EXPECT_DOUBLE_EQ(m[0].median_margin, 149.0 / 200);
  EXPECT_DOUBLE_EQ(m[0].extreme, 101);
  EXPECT_DOUBLE_EQ(m[0].extreme_margin, 99.0 / 200);
  EXPECT_DOUBLE_EQ(m[1].extreme, 1);
  EXPECT_DOUBLE_EQ(m[1].extreme_margin, -39.0 / 40);
  EXPECT_EQ(m[1].missed, 39u);
  EXPECT_DOUBLE_EQ(m[2].median_margin, -51);  // in the quantity's unit
}

// Of 100 runs 10 miss a <= 90, and of these 5 miss b <= 47.5, too.
TEST(LimitMargins, SayWhichLimitDecides) {
  const auto m = limit_margins(counted_runs(100, {at_most("a", 90), at_most("b", 47.5)}));
  EXPECT_EQ(m[0].missed, 10u);
  EXPECT_EQ(m[0].alone, 5u);
  EXPECT_EQ(m[0].role, LimitRole::decides);
  EXPECT_NEAR(m[0].missed_lower, 0.0490, 1e-4);  // Clopper-Pearson, 10 of 100, 95 %
  EXPECT_NEAR(m[0].missed_upper, 0.1762, 1e-4);
  EXPECT_EQ(m[1].missed, 5u);
  EXPECT_EQ(m[1].alone, 0u);
  EXPECT_EQ(m[1].role, LimitRole::follows);
}

// 0.95^59 = 0.0485 and 0.95^58 = 0.0510: of 95 % yield at 95 % 59 runs without a miss say enough.
TEST(LimitMargins, WithoutAMissNeedRunsToSaySo) {
  EXPECT_EQ(runs_without_miss(0.95, 0.95), 59u);
  EXPECT_EQ(runs_without_miss(0.95, 0.99), 299u);
  EXPECT_EQ(limit_margins(counted_runs(59, {at_most("a", 60)}))[0].role, LimitRole::met);
  const LimitMargin few = limit_margins(counted_runs(58, {at_most("a", 60)}))[0];
  EXPECT_EQ(few.role, LimitRole::open);
  EXPECT_EQ(few.runs_needed, 59u);
}

// Moved by 3, a <= 90 is missed by 7 or 13 of 100, within 4.9 to 17.6 %; by 10 by none or 20.
TEST(LimitMargins, JudgeTheModelWhereItsErrorMovesTheShare) {
  const StudyData runs = counted_runs(100, {at_most("a", 90)});
  EXPECT_EQ(limit_margins(runs, {3})[0].role, LimitRole::decides);
  EXPECT_EQ(limit_margins(runs, {10})[0].role, LimitRole::within_model_error);
  EXPECT_EQ(limit_margins(runs, {std::nan("")})[0].role, LimitRole::decides);
  const StudyData far = counted_runs(100, {at_most("a", 110)});
  EXPECT_EQ(limit_margins(far, {5})[0].role, LimitRole::met);
  EXPECT_EQ(limit_margins(far, {20})[0].role, LimitRole::within_model_error);
}

TEST(LimitMargins, CountRunsWithoutAJudgement) {
  StudyData runs = counted_runs(100, {at_most("a", 90), at_most("unheard", 1)});
  runs.status[99] = RunStatus::jammed;  // a miss of the cage
  runs.status[98] = RunStatus::failed;
  const auto m = limit_margins(runs);
  EXPECT_EQ(m[0].missed, 8u);
  EXPECT_EQ(m[0].judged, 98u);
  EXPECT_EQ(m[0].unknown, 1u);
  EXPECT_EQ(m[0].extreme, 98);
  EXPECT_EQ(m[1].unknown, 99u);
  EXPECT_TRUE(std::isnan(m[1].median_margin));
}

}  // namespace
}  // namespace cagetol
