#include "analysis/tolerance/campaign.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
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
  CampaignSettings settings = {};
  std::optional<CampaignPlan> kept = {};

  std::optional<StudyData> run(const Stage& stage) {
    asked.push_back(stage);
    if (stage.name == interrupted_at) return std::nullopt;
    auto width = kPrintedWidth, length = kPrintedLength;
    if (!stage.tolerances.empty()) {
      width.scales = {stage.tolerances[0].tolerance_width_mm / 0.1};
      length.scales = {stage.tolerances[1].tolerance_width_mm / 0.1};
    }
    StudyData study = tolerance_standin(static_cast<std::int64_t>(stage.rows),
                                        100 * seed + static_cast<std::int64_t>(asked.size()),
                                        {width, length}, target, badness);
    study.plan.campaign = settings;
    study.plan.campaign.attempts = attempts;
    return study;
  }

  Campaign campaign() {
    asked.clear();
    kept.reset();
    return go_on();
  }
  Campaign go_on() {
    asked.clear();
    return run_campaign(
        {"pilot", 64, {}},
        [&](const StudyData& pilot) {
          return kept ? *kept : plan_campaign(pilot, pilot.plan.campaign, mixture_rows, 1);
        },
        [&](const Stage& stage) { return run(stage); },
        [&](const CampaignPlan& plan) { kept = plan; });
  }
};

TEST(Campaign, ConfirmsTheWidestToleranceThatMeetsTheTarget) {
  Bench bench;
  const Campaign campaign = bench.campaign();
  ASSERT_EQ(campaign.end, CampaignEnd::confirmed);
  const Attempt& last = campaign.attempts.back();
  EXPECT_NEAR(last.recommendation.tolerances[0].tolerance_width_mm, 0.09, 1e-12);
  EXPECT_TRUE(last.recommendation.tolerances[1].not_binding);
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
        widest_pocket_yield(
            campaign.attempts.back().recommendation.tolerances[0].tolerance_width_mm) < target;
    rates.confirmed += confirmed ? 1.0 / repeats : 0;
    rates.covered += wrong ? 0 : 1.0 / repeats;
  }
  return rates;
}

// The target lies just above the yield of the tolerance of 0.09 mm, 0.9751: the worst place for it.
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

TEST(Campaign, TriesTheNextNarrowerToleranceWithFreshRuns) {
  // From the third stage on a tenth of the cages fail whatever the tolerance: nothing can be
  // confirmed.
  Bench bench;
  int calls = 0;
  bench.badness = [&](const StandinCage& cage) {
    const bool confirming = bench.asked.size() > 2;
    return confirming && ++calls % 10 == 0 ? 1.0 : widest_pocket(cage);
  };
  const Campaign campaign = bench.campaign();
  EXPECT_EQ(campaign.end, CampaignEnd::not_confirmed);
  ASSERT_EQ(campaign.attempts.size(), 2u);
  EXPECT_LT(campaign.attempts[1].recommendation.tolerances[0].tolerance_width_mm,
            campaign.attempts[0].recommendation.tolerances[0].tolerance_width_mm);
  EXPECT_EQ(bench.asked.back().name, "confirm-2");
}

TEST(Campaign, TriesNarrowerTolerancesOfADimensionThatWasNotBinding) {
  // No tolerance matters in pilot and mixture. Confirming runs fail in a tenth of the cages at the
  // widest.
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
    EXPECT_TRUE(campaign.attempts[0].recommendation.tolerances[d].not_binding);
  EXPECT_LT(campaign.attempts[1].recommendation.tolerances[0].tolerance_width_mm *
                campaign.attempts[1].recommendation.tolerances[1].tolerance_width_mm,
            campaign.attempts[0].recommendation.tolerances[0].tolerance_width_mm *
                campaign.attempts[0].recommendation.tolerances[1].tolerance_width_mm);
}

TEST(Campaign, TriesTheWidestThatMeetsTheTargetWhileAttemptsRemain) {
  // Estimated at 97.5 %, the tolerance of 0.09 mm is unlikely to be confirmed at 96.5 % by so few
  // runs.
  Bench bench{.target = 0.965, .mixture_rows = 600};
  const Campaign campaign = bench.campaign();
  ASSERT_GE(campaign.attempts.size(), 1u);
  EXPECT_NEAR(campaign.attempts[0].recommendation.tolerances[0].tolerance_width_mm, 0.09, 1e-12);
  ASSERT_EQ(campaign.end, CampaignEnd::confirmed);
  EXPECT_LE(campaign.attempts.back().recommendation.tolerances[0].tolerance_width_mm, 0.09 + 1e-12);
}

TEST(Campaign, GoesOnWithALargerBudget) {
  // Nothing is confirmed by the first attempt, which spends what there is.
  Bench bench{.mixture_rows = 600};
  int calls = 0;
  bench.badness = [&](const StandinCage& cage) {
    const bool confirming = bench.asked.size() == 3;
    return confirming && ++calls % 10 == 0 ? 1.0 : widest_pocket(cage);
  };
  bench.settings.budget_samples = 1300;
  const Campaign poor = bench.campaign();
  const auto whole = bench.asked;
  ASSERT_TRUE(bench.kept);
  const StudyData pilot = *bench.run({"pilot", 64, {}});
  const CampaignPlan before = *bench.kept;
  bench.settings.budget_samples = 20000;
  bench.kept = with_settings(before, pilot, bench.settings);
  EXPECT_EQ(bench.kept->mixture_rows, before.mixture_rows);
  EXPECT_EQ(bench.kept->confirm_runs, before.confirm_runs + 18700);
  bench.go_on();
  ASSERT_GE(bench.asked.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_EQ(bench.asked[i].rows, whole[i].rows);
  bench.settings.budget_samples = 700;
  EXPECT_THROW(with_settings(before, pilot, bench.settings), Refused);
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

/// The tolerance whose cages have this yield: Phi(0.26 mm / tolerance)^13.
double tolerance_of_yield(double yield) {
  return 0.26 / gsl_cdf_ugaussian_Pinv(std::pow(yield, 1.0 / 13));
}

/// Grades 3 and 1 % above and 1 % below the target, and a budget of runs for all stages.
struct Neighbours {
  double target = 0.9;
  std::size_t budget = 30000;

  struct Found {
    double covered = 0, largest = 0;
  };
  Found rates(int repeats, std::int64_t first_seed) const {
    const std::vector<double> scales = {10 * tolerance_of_yield(std::min(target + 0.03, 0.999)),
                                        10 * tolerance_of_yield(target + 0.01),
                                        10 * tolerance_of_yield(target - 0.01)};
    Found found;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      std::int64_t seed = 10 * (first_seed + repeat);
      const Campaign campaign = run_campaign(
          {"pilot", 128, {}},
          [&](const StudyData& pilot) {
            return plan_campaign(pilot, {.budget_samples = budget}, 0, 1);
          },
          [&](const Stage& stage) -> std::optional<StudyData> {
            StandinDimension width = kPrintedWidth;
            width.key = "roller.taper_um";  // no size: no grade of ISO 286 to snap to
            width.scales = stage.tolerances.empty()
                               ? scales
                               : std::vector{10 * stage.tolerances[0].tolerance_width_mm};
            return tolerance_standin(static_cast<std::int64_t>(stage.rows), ++seed, {width}, target,
                                     widest_pocket);
          },
          [](const CampaignPlan&) {});
      const bool confirmed = campaign.end == CampaignEnd::confirmed;
      const double width =
          confirmed ? campaign.attempts.back().recommendation.tolerances[0].tolerance_width_mm : 0;
      const bool wrong = confirmed && campaign.attempts.back().confirmation.yield.lower_bound >
                                          widest_pocket_yield(width);
      found.covered += wrong ? 0 : 1.0 / repeats;
      found.largest += std::abs(10 * width - scales[1]) < 1e-9 ? 1.0 / repeats : 0;
    }
    std::printf("target %g, budget %zu, %d repeats: covered %.3f, largest passing grade %.3f\n",
                target, budget, repeats, found.covered, found.largest);
    return found;
  }
};

// Bands are given in mm: grades of ISO 286 do not fall where neighbours are wanted.
class NightlyNeighbours : public testing::TestWithParam<Neighbours> {};

TEST_P(NightlyNeighbours, AreToldApartInFourHundredRepeats) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  const Neighbours::Found found = GetParam().rates(400, 1);
  EXPECT_GE(found.covered, 0.925);
  EXPECT_GE(found.largest, 0.8);
}

INSTANTIATE_TEST_SUITE_P(Targets, NightlyNeighbours,
                         testing::Values(Neighbours{0.90, 30000}, Neighbours{0.95, 16000},
                                         Neighbours{0.98, 8000}),
                         [](const auto& each) {
                           return "Target" + std::to_string(std::lround(100 * each.param.target));
                         });

TEST(Neighbours, AreToldApart) {
  const auto found = Neighbours{0.98, 8000}.rates(8, 7);
  EXPECT_GE(found.covered, 0.75);
  EXPECT_GE(found.largest, 0.5);
}

TEST(LostRuns, AreCertainlyTooManyOnlyByTheirLowerBound) {
  // One of 32: 1 - 0.95^(1/32).
  EXPECT_NEAR((LostRuns{1, 32}.minimum_share()), 1 - std::pow(0.95, 1.0 / 32), 1e-9);
  EXPECT_EQ((LostRuns{0, 32}.minimum_share()), 0);
  StudyData pilot = tolerance_standin(100, 3, {kPrintedWidth, kPrintedLength}, 0.95, widest_pocket);
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

}  // namespace
}  // namespace cagetol
