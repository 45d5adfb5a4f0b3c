#include "analysis/tolerance/attempt_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

/// Tolerances of 0.058, 0.09 and 0.15 mm, whose yields are 0.99995, 0.9751 and 0.5731.
MixtureStudy mixture_of(double target, std::int64_t rows = 900) {
  StandinDimension width = kPrintedWidth;
  width.scales = {0.58, 0.9, 1.5};
  StudyData study = tolerance_standin(rows, 17, {width}, target, widest_pocket);
  study.plan.campaign.attempts = 2;
  return study_mixture(study);
}

/// The first choice, or the one after these attempts.
std::optional<AttemptChoice> choice(const MixtureStudy& mixture, CampaignPlan plan,
                                    const std::vector<Tried>& tried = {}) {
  return choose_attempt(mixture, plan, tried);
}

double tolerance_width(const AttemptChoice& choice) {
  return choice.recommendation.tolerances[0].tolerance_width_mm;
}

TEST(ChooseAttempt, TakesTheWidestWhileAnotherAttemptRemains) {
  const MixtureStudy mixture = mixture_of(0.9);
  const CampaignPlan plan{.mixture_rows = 900, .confirm_runs = 900, .error_shares = 2};
  const auto first = choice(mixture, plan);
  ASSERT_TRUE(first);
  EXPECT_NEAR(tolerance_width(*first), 0.09, 1e-12);
  // Runs are left for the narrower one.
  EXPECT_LE(first->runs + confirming_runs(0, confirmation_rules(mixture.runs.plan, 0)), 900u);
  CampaignPlan failed = plan;
  failed.attempts = {{first->recommendation.candidate, first->runs, first->runs}};
  const auto second = choice(mixture, failed, {{{{0.09}, {}}, false}});
  ASSERT_TRUE(second);
  EXPECT_NEAR(tolerance_width(*second), 0.058, 1e-12);
  EXPECT_LE(first->runs + second->runs, 900u);
}

TEST(ChooseAttempt, TakesAProbableOneLast) {
  MixtureStudy mixture = mixture_of(0.965);
  mixture.runs.plan.campaign.attempts = 1;
  const auto only = choice(mixture, {.mixture_rows = 900, .confirm_runs = 400});
  ASSERT_TRUE(only);
  EXPECT_NEAR(tolerance_width(*only), 0.058, 1e-12);
}

TEST(ChooseAttempt, AsksForAsManyRunsAsTheYieldNeeds) {
  const CampaignPlan plan{.mixture_rows = 900, .confirm_runs = 100000};
  const auto wide = [&](double target) {
    MixtureStudy mixture = mixture_of(target);
    mixture.runs.plan.campaign.attempts = 1;
    return choice(mixture, plan);
  };
  const auto near = wide(0.965), far = wide(0.93);
  ASSERT_TRUE(near && far);
  EXPECT_NEAR(tolerance_width(*near), tolerance_width(*far), 1e-12);
  EXPECT_GT(near->runs, 3 * far->runs);
}

TEST(ChooseAttempt, NeedsRunsForOneAttempt) {
  const MixtureStudy mixture = mixture_of(0.9);
  // Two attempts take 36 runs each without a failure, one alone 29.
  EXPECT_TRUE(choice(mixture, {.mixture_rows = 900, .confirm_runs = 29}));
  EXPECT_FALSE(choice(mixture, {.mixture_rows = 900, .confirm_runs = 28}));
}

TEST(ChooseAttempt, KnowsFromGeometryWhichCandidateJams) {
  // 60 rows of a tolerance that no run fails: all candidates look alike but for their jams.
  StandinDimension width = kPrintedWidth;
  width.scales = {0.09, 0.15, 0.22};
  StudyData study = tolerance_standin(180, 19, {width}, 0.99, widest_pocket);
  study.plan.campaign.attempts = 1;
  const CampaignPlan plan{.mixture_rows = 180, .confirm_runs = 400};
  const auto chosen = [&](const std::vector<double>& jams) {
    study.jam.candidate = jams;
    const auto next = choice(study_mixture(study), plan);
    return next ? tolerance_width(*next) : 0;
  };
  EXPECT_NEAR(chosen({}), 0.022, 1e-12);
  EXPECT_NEAR(chosen({0, 0, 0.006}), 0.015, 1e-12);
  EXPECT_NEAR(chosen({0, 0.02, 0.1}), 0.009, 1e-12);
  EXPECT_EQ(chosen({0.02, 0.02, 0.1}), 0);
}

TEST(ChooseAttempt, FewRunsOfManyCandidatesArePooledByTolerance) {
  StandinDimension width = kPrintedWidth, length = kPrintedLength;
  width.scales = length.scales = {0.1, 0.15, 0.2, 0.3, 0.45, 0.6, 0.9};
  const StudyData study = tolerance_standin(400, 20, {width, length}, 0.99, widest_pocket);
  const MixtureStudy mixture = study_mixture(study);
  int pooled = 0;
  for (const Yield& yield : mixture.tolerances.curves.candidates) {
    EXPECT_GE(yield.ess, kMinimumEffectiveRuns);  // 8 rows each
    pooled += yield.method.find("product of the yields of its tolerances") != std::string::npos;
  }
  EXPECT_GE(pooled, 15);
  // Lengths do nothing, widths of 0.09 mm fail in 2.5 % of cages.
  const auto& candidates = mixture.tolerances.curves.candidates;
  for (std::size_t k = 0; k < candidates.size(); ++k)
    EXPECT_NEAR(candidates[k].if_unknown_fail,
                widest_pocket_yield(study.plan.candidates[k].tolerance_widths_mm[0]), 0.05)
        << k;
}

TEST(ChooseAttempt, GoesFromNarrowToWideWhereThatTakesFewerRuns) {
  // 0.09 mm is near the target, 0.058 mm takes few runs: first it, with the whole error.
  const MixtureStudy mixture = mixture_of(0.95);
  CampaignPlan plan{.mixture_rows = 900, .confirm_runs = 4000};
  const auto first = choose_attempt(mixture, plan, {});
  ASSERT_TRUE(first);
  EXPECT_EQ(plan.error_shares, 1u);
  EXPECT_NEAR(tolerance_width(*first), 0.058, 1e-12);
  plan.attempts = {{first->recommendation.candidate, first->runs, first->runs}};
  const auto second = choose_attempt(mixture, plan, {{{{0.058}, {}}, true}});
  ASSERT_TRUE(second);
  EXPECT_NEAR(tolerance_width(*second), 0.09, 1e-12);
  EXPECT_FALSE(choose_attempt(mixture, plan, {{{{0.058}, {}}, false}}));  // ends the sequence
  // At 90 % both take the fewest runs: the wide one first, then the narrow one if it fails.
  CampaignPlan easy{.mixture_rows = 900, .confirm_runs = 4000};
  const auto wide = choose_attempt(mixture_of(0.9), easy, {});
  ASSERT_TRUE(wide);
  EXPECT_EQ(easy.error_shares, 2u);
  EXPECT_NEAR(tolerance_width(*wide), 0.09, 1e-12);
}

TEST(PassedOver, SaysWhatJams) {
  MixtureStudy mixture = mixture_of(0.965);
  mixture.runs.jam.candidate = {0, 0.1, 0.5};
  const auto list = passed_over(mixture.runs, mixture.tolerances.curves, {{{0.058}, {}}});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_THAT(list[0].reason, HasSubstr("10.0 % of its cages jam"));
  EXPECT_EQ(list[0].runs_needed, 0u);
}

TEST(PassedOver, NamesEveryWiderCandidateThatNoAttemptTried) {
  const MixtureStudy mixture = mixture_of(0.965);
  const auto list = passed_over(mixture.runs, mixture.tolerances.curves, {{{0.058}, {}}});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].candidate, 1u);
  EXPECT_THAT(list[0].reason, HasSubstr("hardly have confirmed"));
  EXPECT_GT(list[0].runs_needed, 500u);
  EXPECT_EQ(list[1].candidate, 2u);
  EXPECT_THAT(list[1].reason, HasSubstr("below the target"));
  EXPECT_EQ(list[1].runs_needed, 0u);
  // Tried and decided for: nothing but the widest is left.
  EXPECT_EQ(
      passed_over(mixture.runs, mixture.tolerances.curves, {{{0.09}, {}}, {{0.058}, {}}}).size(),
      1u);
  EXPECT_TRUE(passed_over(mixture.runs, mixture.tolerances.curves, {}).empty());
}

}  // namespace
}  // namespace cagetol
