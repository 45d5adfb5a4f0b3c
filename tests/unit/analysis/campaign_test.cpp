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

/// The runs up to the one that uses up the allowed failures of a confirmation, as a sweep ends.
StudyData until_used_up(const StudyData& all, const Stage& stage) {
  const auto joint = judge_all(all);
  std::vector<std::size_t> runs;
  std::size_t failures = 0;
  for (std::size_t i = 0; i < all.size() && failures <= stage.allowed_failures.value_or(i); ++i) {
    failures += joint[i] != Judgement::meets;
    runs.push_back(i);
  }
  StudyData ended = select_samples(all, runs);
  if (stage.allowed_failures) ended.plan.campaign.attempts = stage.error_shares;
  return ended;
}

/// The widest tolerance that was confirmed.
const Attempt* confirmed_attempt(const Campaign& campaign) {
  const Attempt* last = nullptr;
  for (const Attempt& attempt : campaign.attempts)
    if (attempt.confirmation.passed) last = &attempt;
  return last;
}

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
    return until_used_up(study, stage);
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
  const Attempt& last = *confirmed_attempt(campaign);
  EXPECT_NEAR(last.recommendation.tolerances[0].tolerance_width_mm, 0.09, 1e-12);
  EXPECT_TRUE(last.recommendation.tolerances[1].not_binding);
  EXPECT_GE(last.confirmation.yield.lower_bound, 0.95);
  ASSERT_EQ(bench.asked.size(), 2 + campaign.attempts.size());
  EXPECT_EQ(bench.asked[1].name, "mixture");
  EXPECT_EQ(bench.asked[1].rows, 1200u);
  EXPECT_EQ(bench.asked[2].name, "confirm-1");
  EXPECT_EQ(bench.asked[2].rows, campaign.attempts[0].confirmation.runs);
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
            confirmed_attempt(campaign)->recommendation.tolerances[0].tolerance_width_mm) < target;
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
  // From the third stage on a fifth of the cages fail whatever the tolerance: nothing can be
  // confirmed. Two tolerances take the fewest runs, so that the wide one is tried first.
  Bench bench{.target = 0.9};
  int calls = 0;
  bench.badness = [&](const StandinCage& cage) {
    const bool confirming = bench.asked.size() > 2;
    return confirming && ++calls % 5 == 0 ? 1.0 : widest_pocket(cage);
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
  bench.campaign();
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
  // Before an attempt is decided the mixture grows too.
  CampaignPlan open = before;
  open.attempts.clear();
  bench.settings.budget_samples = 2600;
  const CampaignPlan grown = with_settings(open, pilot, bench.settings);
  EXPECT_GT(grown.mixture_rows, before.mixture_rows);
  EXPECT_EQ(grown.mixture_rows + grown.confirm_runs, 2600u - pilot.size());
}

TEST(Campaign, ExtendsTheMixtureWhileNoCandidateIsFound) {
  // One in 17 fails in the first rows, which were unlucky, whatever the tolerance.
  Bench bench;
  int calls = 0;
  bench.badness = [&](const StandinCage& cage) {
    return bench.asked.size() == 2 && ++calls % 17 == 0 ? 1.0 : widest_pocket(cage);
  };
  bench.settings.budget_samples = 1300;
  const Campaign campaign = bench.campaign();
  ASSERT_GE(bench.asked.size(), 4u);
  EXPECT_EQ(bench.asked[1].name, "mixture");
  EXPECT_EQ(bench.asked[2].name, "mixture");
  EXPECT_GT(bench.asked[2].rows, bench.asked[1].rows);
  EXPECT_EQ(campaign.end, CampaignEnd::confirmed);
  EXPECT_EQ(bench.kept->mixture_rows, bench.asked[2].rows);
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

/// A campaign over tolerances of these yields, narrow to wide, and a budget of runs for all stages.
struct KnownYields {
  std::string name;
  double target = 0.9;
  std::size_t budget = 3200;
  std::vector<double> yields;

  /// Shares of repeats: bound holds; the widest passing one confirmed; it or the next narrower one;
  /// two or more below it; a tolerance below the target.
  struct Found {
    double covered = 0, widest = 0, near = 0, below = 0, wrong = 0;
  };
  Found rates(int repeats, std::int64_t first_seed) const {
    std::vector<double> scales;
    for (const double yield : yields) scales.push_back(10 * tolerance_of_yield(yield));
    const auto passing =
        std::count_if(yields.begin(), yields.end(), [&](double each) { return each >= target; });
    Found found;
    for (int repeat = 0; repeat < repeats; ++repeat) {
      const std::int64_t seed = 100 * (first_seed + repeat);
      std::vector<StudyData> confirming;
      const Campaign campaign = run_campaign(
          {"pilot", 64, {}},
          [&](const StudyData& pilot) {
            return plan_campaign(pilot, {.budget_samples = budget}, 0, 1);
          },
          [&](const Stage& stage) -> std::optional<StudyData> {
            const bool fresh = !stage.tolerances.empty();
            StandinDimension width = kPrintedWidth;
            width.key = "roller.taper_um";  // no size: no grade of ISO 286 to snap to
            width.scales =
                fresh ? std::vector{10 * stage.tolerances[0].tolerance_width_mm} : scales;
            const auto place =
                fresh ? static_cast<std::int64_t>(confirming.size()) + 2 : stage.name == "mixture";
            StudyData runs =
                until_used_up(tolerance_standin(static_cast<std::int64_t>(stage.rows), seed + place,
                                                {width}, target, widest_pocket),
                              stage);
            if (!fresh) runs.plan.campaign.attempts = 2;
            if (fresh) confirming.push_back(runs);
            return runs;
          },
          [](const CampaignPlan&) {});
      const Attempt* confirmed = confirmed_attempt(campaign);
      EXPECT_EQ(confirmed != nullptr, campaign.end == CampaignEnd::confirmed);
      std::ptrdiff_t place = -1;
      for (std::size_t k = 0; k < scales.size() && confirmed != nullptr; ++k)
        if (std::abs(10 * confirmed->recommendation.tolerances[0].tolerance_width_mm - scales[k]) <
            1e-9)
          place = static_cast<std::ptrdiff_t>(k);
      const double one = 1.0 / repeats;
      found.covered += place < 0 || judge_attempts(confirming).lower_bound <=
                                        yields[static_cast<std::size_t>(place)]
                           ? one
                           : 0;
      found.widest += place >= 0 && place == passing - 1 ? one : 0;
      found.near += place >= 0 && (place == passing - 1 || place == passing - 2) ? one : 0;
      found.below += place >= 0 && place < passing - 2 ? one : 0;
      found.wrong += place >= passing ? one : 0;
    }
    std::printf(
        "%s, target %g, budget %zu, %d repeats: bound holds %.3f, widest passing %.3f, it or the "
        "next narrower %.3f, two below %.3f, below the target %.3f\n",
        name.c_str(), target, budget, repeats, found.covered, found.widest, found.near, found.below,
        found.wrong);
    return found;
  }
};

std::ostream& operator<<(std::ostream& out, const KnownYields& each) {
  return out << each.name;
}

const auto name_of = [](const auto& each) { return each.param.name; };

class NightlyNeighbours : public testing::TestWithParam<KnownYields> {};

TEST_P(NightlyNeighbours, AreToldApartInFourHundredRepeats) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  const auto found = GetParam().rates(400, 1);
  EXPECT_GE(found.covered, 0.925);
  EXPECT_GE(found.widest, 0.8);
}

// 3 and 1 % above and 1 % below the target.
INSTANTIATE_TEST_SUITE_P(Targets, NightlyNeighbours,
                         testing::Values(KnownYields{"Target90", 0.9, 30000, {0.93, 0.91, 0.89}},
                                         KnownYields{"Target95", 0.95, 16000, {0.98, 0.96, 0.94}},
                                         KnownYields{"Target98", 0.98, 8000, {0.999, 0.99, 0.97}}),
                         name_of);

TEST(Neighbours, AreToldApart) {
  const auto found = KnownYields{"Target98", 0.98, 8000, {0.999, 0.99, 0.97}}.rates(8, 7);
  EXPECT_GE(found.covered, 0.75);
  EXPECT_GE(found.widest, 0.5);
}

class KnownYieldsTest : public testing::TestWithParam<KnownYields> {
 protected:
  void expect(int repeats, double slack) const {
    const auto found = GetParam().rates(repeats, 1);
    EXPECT_GE(found.covered, 0.925 - slack);
    EXPECT_LE(found.wrong, 0.05 + slack);
    if (GetParam().yields.front() < GetParam().target) return;
    EXPECT_GE(found.near, 0.88 - slack);
    EXPECT_LE(found.below, 0.09 + slack);
  }
};

TEST_P(KnownYieldsTest, ConfirmTheWidestOrTheNext) {
  expect(12, 0.1);
}

TEST_P(KnownYieldsTest, NightlyConfirmTheWidestOrTheNextInFourHundred) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  expect(400, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Yields, KnownYieldsTest,
    testing::Values(KnownYields{"Apart", 0.9, 3200, {0.999, 0.992, 0.94, 0.865}},
                    KnownYields{"NearAbove", 0.9, 3200, {0.999, 0.992, 0.94, 0.91}},
                    KnownYields{"NearBelow", 0.9, 3200, {0.999, 0.992, 0.94, 0.89}},
                    KnownYields{"None", 0.9, 3200, {0.89, 0.865, 0.8, 0.7}}),
    name_of);

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
