// Claims count once, and hold from a level on.
#include "analysis/response/claims.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "analysis/report/json_parts.hpp"
#include "analysis/report/report.hpp"
#include "tests/support/report_page.hpp"
#include "tests/support/synthetic_grid.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

TEST(Claims, AgreeWhereAllTheirReadingsDo) {
  using enum TrendVerdict;
  const auto judged = [](std::initializer_list<TrendVerdict> readings) {
    return judge_claim(std::vector<TrendVerdict>(readings));
  };
  EXPECT_EQ(judged({agrees, agrees}), ClaimVerdict::agrees);
  EXPECT_EQ(judged({agrees, disagrees}), ClaimVerdict::in_part);
  EXPECT_EQ(judged({agrees, no_values}), ClaimVerdict::in_part);
  EXPECT_EQ(judged({undecided, disagrees}), ClaimVerdict::disagrees);
  EXPECT_EQ(judged({undecided, no_values}), ClaimVerdict::undecided);
  EXPECT_EQ(judged({no_claim, no_claim}), ClaimVerdict::no_claim);
  EXPECT_EQ(judged({no_values}), ClaimVerdict::no_values);
}

TEST(Claims, TryLevelsFromTheNearestToTheLast) {
  const auto cells = grid_cells(make_synthetic_grid(1), "cage.pocket_length_mm");
  EXPECT_THAT(levels_towards(*cells, 0, -0.125), ElementsAre(1, 0));
  EXPECT_THAT(levels_towards(*cells, -0.125, 0), ElementsAre(2, 3, 4));
  EXPECT_THAT(levels_towards(*cells, -0.1, 0), IsEmpty());
  EXPECT_THAT(unbroken({true, false, true, true}), ElementsAre(Pair(0, 0), Pair(2, 3)));
  EXPECT_THAT(unbroken({false}), IsEmpty());
}

/// Slip of 1, and of 5 in pockets shorter by 0.125 mm and more; lower by `misaligned` in the other
/// setting's short pockets. Read against two longer pockets.
StudyData jumping_slip(double misaligned) {
  StudyData study = make_synthetic_grid();
  study.plan.scene["roller"]["length_mm"] = 9.0;
  for (std::size_t i = 0; i < study.size(); ++i) {
    const double small = 1e-3 * static_cast<double>(i % 7);
    const bool is_short = study.inputs[1].lot[i] < -0.1;
    study.quantities[0].values[i] =
        small + (is_short ? 5 - (study.inputs[0].lot[i] > 0 ? misaligned : 0) : 1);
  }
  Trend trend = study.plan.trends[0];
  trend.claim = "slip jumps";
  trend.expected = "rises";
  trend.by_share = 1;
  trend.to = -0.25;
  study.plan.trends.clear();
  for (const double from : {0.0, 0.25}) {
    trend.from = from;
    study.plan.trends.push_back(trend);
  }
  return study;
}

TEST(Claims, CountOnceAndHoldFromAClearanceOn) {
  const Json report = make_report(jumping_slip(0));
  const Json& trends = report.at("trends");
  EXPECT_EQ(trends.at("verdicts"), Json({{"agrees", 4}}));
  EXPECT_EQ(trends.at("claim_verdicts"), Json({{"agrees", 1}}));
  ASSERT_EQ(trends.at("claims").size(), 1U);
  const Json& held = trends.at("claims")[0].at("held");
  ASSERT_EQ(held.size(), 2U);
  for (const Json& setting : held) {
    ASSERT_EQ(setting.at("ranges").size(), 1U);
    const Json& range = setting.at("ranges")[0];
    EXPECT_EQ(range.at("first").at("clearance"), 0.275);
    EXPECT_TRUE(range.at("before").is_null());
    EXPECT_EQ(range.at("to_the_end"), true);
    EXPECT_EQ(range.at("differences").size(), 2U);
    EXPECT_NEAR(range.at("differences")[0].at("difference").at("value").get<double>(), 4, 0.01);
  }
  const std::string page = page_of(report);
  EXPECT_THAT(page, HasSubstr("Claims: agrees 1."));
  EXPECT_THAT(page, HasSubstr("from 0.275 mm to 0.15 mm, the last level"));
  EXPECT_THAT(page, HasSubstr("at 0.275 mm against 0.65 mm: slip"));
}

TEST(Claims, SayWhereTheyNeverHold) {
  const Json report = make_report(jumping_slip(3.5));
  EXPECT_EQ(report.at("trends").at("claim_verdicts"), Json({{"agrees in part", 1}}));
  EXPECT_THAT(page_of(report),
              HasSubstr("<i>bearing misalignment z 2 mrad:</i> never (levels tried: 2)"));
}

TEST(Claims, AreNotDeniedWhereTheyAreUndecided) {
  StudyData study = jumping_slip(0);
  for (std::size_t i = 0; i < study.size(); ++i)  // noise in every second run, larger than the jump
    study.quantities[0].values[i] +=
        study.inputs[1].lot[i] < -0.1 && study.replicate[i] % 2 ? 9 : 0;
  for (Trend& trend : study.plan.trends) trend.by_share = 8;
  EXPECT_THAT(page_of(make_report(study)),
              HasSubstr("nowhere for certain (levels tried: 2, undecided at 2)"));
}

TEST(Claims, HaveNoClearanceWhereTheDimensionLeavesNone) {
  StudyData study = make_synthetic_grid(2);
  EXPECT_FALSE(nominal_clearance(study.plan, "cage.pocket_length_mm"));
  study.plan.scene["roller"]["length_mm"] = {9.0, 9.1};
  EXPECT_FALSE(nominal_clearance(study.plan, "cage.pocket_length_mm"));
  study.plan.scene["roller"]["length_mm"] = {9.0, 9.0};
  EXPECT_NEAR(*nominal_clearance(study.plan, "cage.pocket_length_mm"), 0.4, 1e-12);
  EXPECT_FALSE(nominal_clearance(study.plan, "bearing.misalignment_z_mrad"));
}

}  // namespace
}  // namespace cagetol
