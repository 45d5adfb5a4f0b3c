#include "analysis/tolerance/campaign_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "analysis/study/refused.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;

StudyData pilot_of() {
  StudyData pilot = tolerance_standin(100, 3, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  pilot.timing = {{"wall_s", "s", "", std::vector<double>(100, 2.0)}};
  return pilot;
}

TEST(PlanCampaign, WithoutABudgetTheMixtureHasTheRowsOfTheStudy) {
  const CampaignPlan plan = plan_campaign(pilot_of(), {}, 480, 4);
  EXPECT_EQ(plan.mixture_rows, 480u);
  EXPECT_EQ(plan.confirm_runs, 2 * 480u);
  EXPECT_DOUBLE_EQ(plan.seconds_per_run, 2);
  // Twice the fewest that can confirm: 0.95^n <= 0.025 for n = 72.
  EXPECT_EQ(plan_campaign(pilot_of(), {}, 120, 4).confirm_runs, 2 * 144u);
}

TEST(PlanCampaign, SharesABudgetOfRuns) {
  StudyData pilot = pilot_of();
  CampaignSettings settings{.confirm_samples = 300, .budget_samples = 2100};
  // 2000 runs are left: 2 * 300 confirm, the mixture has half at most.
  CampaignPlan plan = plan_campaign(pilot, settings, 480, 1);
  EXPECT_EQ(plan.mixture_rows, 1000u);
  EXPECT_EQ(plan.confirm_runs, 1000u);
  // Two times 900 would leave it a tenth: it keeps a quarter.
  pilot.plan.extra_replicates = 0.25;
  settings.confirm_samples = 900;
  plan = plan_campaign(pilot, settings, 480, 1);
  EXPECT_EQ(plan.mixture_rows, 400u);  // 500 / 1.25
  EXPECT_EQ(plan.confirm_runs, 1500u);
  // 40 rows for each of four widths first, of no more than half.
  settings = {.confirm_samples = 900, .budget_samples = 600};
  EXPECT_EQ(plan_campaign(pilot, settings, 480, 1).mixture_rows, 160u);
  settings.budget_samples = 400;
  EXPECT_EQ(plan_campaign(pilot, settings, 480, 1).mixture_rows, 120u);  // 150 / 1.25
}

TEST(PlanCampaign, LeavesConfirmationsMoreWhereTheYieldIsNearTheTarget) {
  // Without a failing run the pilot's bound tells its size alone; with one the yield may be
  // anything.
  StudyData sound = tolerance_standin(100, 3, {kPrintedWidth, kPrintedLength}, 0.95,
                                      [](const StandinCage&) { return -1.0; });
  const CampaignSettings settings{.budget_samples = 4100};
  EXPECT_EQ(plan_campaign(sound, settings, 480, 1).mixture_rows, 2000u);
  EXPECT_EQ(plan_campaign(pilot_of(), settings, 480, 1).mixture_rows, 1000u);
}

// What a screen found leaves nothing to learn of limits: 40 rows for each of four widths.
TEST(PlanCampaign, WhereJamsAloneDecideTheMixtureIsSmall) {
  CampaignSettings settings{.confirm_samples = 900, .budget_samples = 2100};
  EXPECT_EQ(plan_campaign(pilot_of(), settings, 480, 1).mixture_rows, 500u);
  settings.jams_alone = true;
  const CampaignPlan plan = plan_campaign(pilot_of(), settings, 480, 1);
  EXPECT_EQ(plan.mixture_rows, 160u);
  EXPECT_EQ(plan.confirm_runs, 1840u);
  settings.budget_samples = 300;  // half of what is left, and no more
  EXPECT_EQ(plan_campaign(pilot_of(), settings, 480, 1).mixture_rows, 56u);
}

TEST(PlanCampaign, TurnsHoursIntoRuns) {
  // 3600 s on 4 processes at 2 s are 7200 runs, less the pilot's 100.
  const CampaignSettings settings{.confirm_samples = 500, .budget_h = 1};
  const CampaignPlan plan = plan_campaign(pilot_of(), settings, 480, 4);
  EXPECT_EQ(plan.mixture_rows, 3550u);
  EXPECT_EQ(plan.confirm_runs, 3550u);
  const auto text = plan_text(pilot_of(), plan);
  EXPECT_THAT(text, HasSubstr("3550 rows over 8 candidates, 3550 runs, 30 min"));
  EXPECT_THAT(text,
              HasSubstr("2 attempts at 97.5 % confidence each, from 72 runs for one to 3550"));
}

// Widths alone borrow from no other dimension: 30 rows each, which a quarter of the budget behind the
// pilot affords whatever the confirmations want.
TEST(PlanCampaign, SaysWhatJudgesEveryCandidateOfOneDimension) {
  StudyData pilot = tolerance_standin(100, 3, {kPrintedWidth}, 0.95, widest_pocket);
  pilot.timing = {{"wall_s", "s", "", std::vector<double>(100, 2.0)}};
  const std::size_t rows = 30 * pilot.plan.candidates.size();
  CampaignPlan plan = plan_campaign(pilot, {.budget_samples = 2000}, 480, 1);
  plan.mixture_rows = rows - 1;
  EXPECT_THAT(plan_text(pilot, plan),
              HasSubstr("recommend.budget_samples = " + std::to_string(264 + 100) + " gives them"));
  EXPECT_GE(plan_campaign(pilot, {.budget_samples = 264 + 100}, 480, 1).mixture_rows, rows);
  plan.mixture_rows = rows;
  EXPECT_THAT(plan_text(pilot, plan), Not(HasSubstr("budget_samples")));
}

TEST(DecidableText, NamesTheWidestThatFits) {
  const StudyPlan plan = tolerance_standin(10, 3, {kPrintedWidth}, 0.95, widest_pocket).plan;
  const ConfirmationRules rules{0.95, 0.95, 2, 0};
  EXPECT_EQ(decidable_text(plan.candidates, {}, rules, 300),
            "with 300 confirming runs: 0.15 mm to 95 %, where at most 8 of them miss a limit");
  EXPECT_THAT(decidable_text(plan.candidates, {0, 0, 0.01, 0.06}, rules, 300),
              HasSubstr("0.09 mm to 95 %"));
  EXPECT_THAT(decidable_text(plan.candidates, {0.1, 0.1, 0.1, 0.1}, rules, 300),
              HasSubstr("no candidate"));
  EXPECT_EQ(decidable_text(plan.candidates, {}, rules, 58),
            "with 58 confirming runs: nothing to 95 %, which takes 59");
}

TEST(PlanCampaign, SaysWhichBudgetWouldDo) {
  try {
    plan_campaign(pilot_of(), {.budget_samples = 160}, 480, 1);
    FAIL();
  } catch (const Refused& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("up to 2 attempts"));
    EXPECT_THAT(refusal.what(), HasSubstr("59 runs are needed to confirm 95 %"));
    EXPECT_THAT(refusal.what(), HasSubstr("220 runs in all are the least"));
  }
}

TEST(LeastBudget, IsEnoughAndNoneLessIs) {
  const StudyData pilot = pilot_of();
  const std::size_t minimum = minimum_budget(confirmation_rules(pilot.plan, 0), 0, pilot.size());
  EXPECT_NO_THROW(plan_campaign(pilot, {.budget_samples = minimum}, 480, 1));
  EXPECT_THROW(plan_campaign(pilot, {.budget_samples = minimum - 1}, 480, 1), Refused);
}

TEST(CampaignPlan, IsReadAsWritten) {
  const CampaignPlan plan{1000,
                          500,
                          2,
                          0.123456789012345678,
                          3,
                          {.attempts = 2,
                           .confirm_samples = 7,
                           .budget_samples = 9,
                           .budget_h = 0.1,
                           .screen_samples = 40,
                           .jams_alone = true},
                          {{4, 300, 300}, {2, 150, 150}}};
  const CampaignPlan read = campaign_plan_of(to_json(plan));
  EXPECT_EQ(to_json(read), to_json(plan));
  EXPECT_EQ(read.settings.screen_samples, 40u);
  EXPECT_TRUE(read.settings.jams_alone);
  EXPECT_EQ(read.mixture_rows, 1000u);
  EXPECT_EQ(read.seconds_per_run, plan.seconds_per_run);
  ASSERT_EQ(read.attempts.size(), 2u);
  EXPECT_EQ(read.attempts[1].candidate, 2u);
  EXPECT_EQ(read.attempts[1].runs, 150u);
}

TEST(PlanCampaign, OtherLimitsOpenItsAttemptsAgain) {
  StudyData pilot = pilot_of();
  const CampaignSettings settings{.confirm_samples = 300, .budget_samples = 2100};
  CampaignPlan plan = plan_campaign(pilot, settings, 480, 1);
  EXPECT_EQ(plan.judgement, judgement_of(pilot.plan));
  plan.attempts = {{2, 300, 40}, {1, 300, 300}};
  pilot.plan.limits[0].maximum = -0.004;
  const CampaignPlan again = with_judgement(plan, pilot, settings);
  EXPECT_TRUE(again.attempts.empty());
  EXPECT_EQ(again.mixture_rows, plan.mixture_rows);
  EXPECT_EQ(again.confirm_runs, plan.confirm_runs);
  EXPECT_EQ(again.judgement.at("limits")[0].at("max"), -0.004);
  EXPECT_EQ(campaign_plan_of(to_json(again)).judgement, again.judgement);
}

}  // namespace
}  // namespace cagetol
