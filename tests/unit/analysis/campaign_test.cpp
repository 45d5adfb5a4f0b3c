#include "analysis/tolerance/campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "analysis/study/refused.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

/// Runs stages on the stand-in, with random numbers of their own as stages of a study have.
struct Bench {
  double target = 0.95;
  std::int64_t seed = 1;
  std::size_t attempts = 2, mixture_rows = 1200;
  std::function<double(const StandinCage&)> badness = widest_pocket;
  std::vector<Stage> asked = {};
  std::string interrupted_at = {};

  std::optional<StudyData> run(const Stage& stage) {
    asked.push_back(stage);
    if (stage.name == interrupted_at) return std::nullopt;
    auto width = kPrintedWidth, length = kPrintedLength;
    if (!stage.bands.empty()) {
      width.scales = {stage.bands[0].band_mm / 0.1};
      length.scales = {stage.bands[1].band_mm / 0.1};
    }
    StudyData study = tolerance_standin(static_cast<std::int64_t>(stage.rows),
                                        100 * seed + static_cast<std::int64_t>(asked.size()),
                                        {width, length}, target, badness);
    study.plan.campaign.attempts = attempts;
    return study;
  }

  Campaign campaign() {
    asked.clear();
    return run_campaign(
        {"pilot", 64, {}},
        [&](const StudyData& pilot) { return plan_campaign(pilot, mixture_rows, 1); },
        [&](const Stage& stage) { return run(stage); });
  }
};

TEST(Campaign, ConfirmsTheWidestBandThatMeetsTheTarget) {
  Bench bench;
  const Campaign campaign = bench.campaign();
  ASSERT_EQ(campaign.end, CampaignEnd::confirmed);
  const Attempt& last = campaign.attempts.back();
  EXPECT_NEAR(last.recommendation.bands[0].band_mm, 0.09, 1e-12);
  EXPECT_TRUE(last.recommendation.bands[1].not_binding);
  EXPECT_GE(last.confirmation.yield.lower_bound, 0.95);
  ASSERT_EQ(bench.asked.size(), 2 + campaign.attempts.size());
  EXPECT_EQ(bench.asked[1].name, "mixture");
  EXPECT_EQ(bench.asked[1].rows, 1200u);
  EXPECT_EQ(bench.asked[2].name, "confirm-1");
  EXPECT_EQ(bench.asked[2].rows, last.confirmation.runs);
}

/// Share of repeats that do not confirm a tolerance below the target, and the share that confirm
/// anything.
struct Rates {
  double covered = 0, confirmed = 0;
};
Rates rates(int repeats, double target) {
  Rates rates;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    Bench bench{.target = target, .seed = 1000 + repeat, .mixture_rows = 900};
    const Campaign campaign = bench.campaign();
    const bool confirmed = campaign.end == CampaignEnd::confirmed;
    const bool wrong =
        confirmed &&
        widest_pocket_yield(campaign.attempts.back().recommendation.bands[0].band_mm) < target;
    rates.confirmed += confirmed ? 1.0 / repeats : 0;
    rates.covered += wrong ? 0 : 1.0 / repeats;
  }
  return rates;
}

// The target lies just above the yield of the band of 0.09 mm, 0.9751: the worst place for it.
constexpr double kWorstTarget = 0.9755;

TEST(Campaign, CoversTheTrueTolerance) {
  const Rates found = rates(40, kWorstTarget);
  EXPECT_GE(found.covered, 0.9);
  EXPECT_GE(found.confirmed, 0.85);  // IT10 meets the target by far
}

TEST(NightlyCampaign, CoversTheTrueToleranceInAThousandRepeats) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  const Rates found = rates(1000, kWorstTarget);
  EXPECT_GE(found.covered, 0.95);
  EXPECT_GE(found.confirmed, 0.95);
}

TEST(Campaign, TriesTheNextNarrowerBandWithFreshRuns) {
  // From the third stage on a tenth of the cages fail whatever the band: nothing can be confirmed.
  Bench bench;
  int calls = 0;
  bench.badness = [&](const StandinCage& cage) {
    const bool confirming = bench.asked.size() > 2;
    return confirming && ++calls % 10 == 0 ? 1.0 : widest_pocket(cage);
  };
  const Campaign campaign = bench.campaign();
  EXPECT_EQ(campaign.end, CampaignEnd::not_confirmed);
  ASSERT_EQ(campaign.attempts.size(), 2u);
  EXPECT_LT(campaign.attempts[1].recommendation.bands[0].band_mm,
            campaign.attempts[0].recommendation.bands[0].band_mm);
  EXPECT_EQ(bench.asked.back().name, "confirm-2");
}

TEST(Campaign, TriesNarrowerBandsOfADimensionThatWasNotBinding) {
  // No band matters in pilot and mixture. Confirming runs fail in a tenth of the cages at the widest.
  Bench bench;
  int calls = 0;
  bench.badness = [&](const StandinCage&) {
    const bool fails = bench.asked.size() == 3 && ++calls % 10 == 0;
    return fails ? 1.0 : -1.0;
  };
  const Campaign campaign = bench.campaign();
  ASSERT_EQ(campaign.attempts.size(), 2u);
  EXPECT_EQ(campaign.end, CampaignEnd::confirmed);
  for (std::size_t d = 0; d < 2; ++d)
    EXPECT_TRUE(campaign.attempts[0].recommendation.bands[d].not_binding);
  EXPECT_LT(campaign.attempts[1].recommendation.bands[0].band_mm *
                campaign.attempts[1].recommendation.bands[1].band_mm,
            campaign.attempts[0].recommendation.bands[0].band_mm *
                campaign.attempts[0].recommendation.bands[1].band_mm);
}

TEST(Campaign, StopsWhereNoCandidateMeetsTheTarget) {
  Bench bench;
  bench.badness = [](const StandinCage& cage) { return cage.pocket[0][0]; };
  const Campaign campaign = bench.campaign();
  EXPECT_EQ(campaign.end, CampaignEnd::no_candidate);
  EXPECT_EQ(bench.asked.size(), 2u);
}

TEST(Campaign, AsksForTheSameStagesAgain) {
  Bench bench;
  bench.campaign();
  const auto whole = bench.asked;
  for (const Stage& stage : whole) {
    bench.interrupted_at = stage.name;
    EXPECT_EQ(bench.campaign().end, CampaignEnd::interrupted);
    EXPECT_EQ(bench.asked.back().name, stage.name);
    EXPECT_EQ(bench.asked.back().rows, stage.rows);
  }
}

StudyData pilot_of(const CampaignSettings& settings, double seconds = 2) {
  StudyData pilot = tolerance_standin(100, 3, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
  pilot.plan.campaign = settings;
  pilot.timing = {{"wall_s", "s", "", std::vector<double>(100, seconds)}};
  return pilot;
}

TEST(PlanCampaign, WithoutABudgetTheMixtureHasTheRowsOfTheStudy) {
  const CampaignPlan plan = plan_campaign(pilot_of({}), 480, 4);
  EXPECT_EQ(plan.mixture_rows, 480u);
  EXPECT_EQ(plan.most_confirm_runs, 480u);
  EXPECT_DOUBLE_EQ(plan.seconds_per_run, 2);
  // Twice the fewest that can confirm: 0.95^n <= 0.025 for n = 72.
  EXPECT_EQ(plan_campaign(pilot_of({}), 120, 4).most_confirm_runs, 144u);
}

TEST(PlanCampaign, SharesABudgetOfRuns) {
  StudyData pilot = pilot_of({.budget_samples = 2100});
  CampaignPlan plan = plan_campaign(pilot, 480, 1);
  EXPECT_EQ(plan.mixture_rows, 1000u);
  EXPECT_EQ(plan.most_confirm_runs, 500u);
  pilot.plan.extra_replicates = 0.25;
  pilot.plan.campaign.confirm_samples = 300;
  plan = plan_campaign(pilot, 480, 1);
  EXPECT_EQ(plan.mixture_rows, 1120u);  // (2000 - 2 * 300) / 1.25
  EXPECT_EQ(plan.most_confirm_runs, 300u);
}

TEST(PlanCampaign, TurnsHoursIntoRuns) {
  // 3600 s on 4 processes at 2 s are 7200 runs, less the pilot's 100.
  const CampaignPlan plan = plan_campaign(pilot_of({.budget_h = 1}), 480, 4);
  EXPECT_EQ(plan.mixture_rows, 3550u);
  EXPECT_EQ(plan.most_confirm_runs, 1775u);
  const auto text = plan_text(pilot_of({.budget_h = 1}), plan);
  EXPECT_THAT(text, HasSubstr("3550 rows over 8 candidates, 3550 runs, 30 min"));
  EXPECT_THAT(text, HasSubstr("2 attempts of 72 to 1775 runs each at 97.5 % confidence"));
}

TEST(PlanCampaign, SaysWhichBudgetWouldDo) {
  try {
    plan_campaign(pilot_of({.budget_samples = 300}), 480, 1);
    FAIL();
  } catch (const Refused& refusal) {
    EXPECT_THAT(refusal.what(), HasSubstr("50 runs for each of 2 attempts"));
    EXPECT_THAT(refusal.what(), HasSubstr("72 runs are needed to confirm 95 %"));
  }
}

TEST(LostRuns, AreCertainlyTooManyOnlyByTheirLowerBound) {
  // One of 32: 1 - 0.95^(1/32).
  EXPECT_NEAR((LostRuns{1, 32}.least_share()), 1 - std::pow(0.95, 1.0 / 32), 1e-9);
  EXPECT_EQ((LostRuns{0, 32}.least_share()), 0);
  StudyData pilot = pilot_of({});
  pilot.status[3] = RunStatus::failed;
  pilot.status[4] = RunStatus::censored;
  pilot.status[5] = RunStatus::jammed;
  LostRuns lost = count_lost(pilot);
  EXPECT_EQ(lost.lost, 2u);
  EXPECT_EQ(lost.runs, 100u);
  lost += {1, 50};
  EXPECT_EQ(lost.lost, 3u);
  EXPECT_EQ(lost.runs, 150u);
}

TEST(CampaignPlan, IsReadAsWritten) {
  const CampaignPlan plan{1000, 500, 0.123456789012345678, 3};
  const CampaignPlan read = campaign_plan_of(to_json(plan));
  EXPECT_EQ(read.mixture_rows, plan.mixture_rows);
  EXPECT_EQ(read.most_confirm_runs, plan.most_confirm_runs);
  EXPECT_EQ(read.seconds_per_run, plan.seconds_per_run);
  EXPECT_EQ(read.processes, plan.processes);
}

}  // namespace
}  // namespace cagetol
