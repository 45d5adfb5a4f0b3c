#include "analysis/tolerance/confirmation.hpp"

#include <gtest/gtest.h>

#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/study/refused.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

TEST(ConfirmingRuns, AreThoseOfWilksWithOneAttempt) {
  const ConfirmationRules p95{0.95, 0.95, 1, 0}, p99{0.99, 0.95, 1, 0};
  const std::size_t of_95[] = {59, 93, 124}, of_99[] = {299, 473, 628};
  for (std::size_t failures = 0; failures < 3; ++failures) {
    EXPECT_EQ(confirming_runs(failures, p95), of_95[failures]);
    EXPECT_EQ(confirming_runs(failures, p99), of_99[failures]);
  }
  EXPECT_THROW(confirming_runs(0, {1.0, 0.95, 1, 0}), Refused);
}

TEST(ConfirmingRuns, ShareTheErrorOverTheAttempts) {
  // 0.95^n <= 0.05 / 4: n = 85.4.
  const ConfirmationRules rules{0.95, 0.95, 4, 0};
  EXPECT_DOUBLE_EQ(attempt_confidence(rules), 0.9875);
  EXPECT_EQ(confirming_runs(0, rules), 86u);
}

/// Runs of one candidate, the share j of whose cages jams.
StudyData fitting_runs(double j, double draws) {
  StudyData runs;
  runs.plan.redraw_jams = true;
  runs.jam.candidate = {j};
  runs.jam.draws = draws;
  return runs;
}

// Pocket widths of IT14: 99.43 % fit. Integrated, from a million draws and from 8192.
TEST(ConfirmingRuns, OfCagesThatFitMultiplyBothBounds) {
  const std::size_t expected[3][2] = {{695, 856}, {741, 915}, {2511, 3796}};
  const double draws[] = {0, 1e6, 8192};
  for (std::size_t i = 0; i < 3; ++i)
    for (const std::size_t attempts : {1, 2}) {
      const StudyData runs = fitting_runs(0.0057228, draws[i]);
      const ConfirmationRules rules = rules_for({0.99, 0.95, attempts, 0}, runs, 0);
      EXPECT_NEAR(static_cast<double>(confirming_runs(0, rules)),
                  static_cast<double>(expected[i][attempts - 1]), i == 2 ? 80 : 1);
      EXPECT_NEAR(confirming_probability(1 - 0.0057228, 1000, rules), i == 2 ? 0 : 1, 1e-9);
    }
  const ConfirmationRules hopeless = rules_for({0.99, 0.95, 1, 0}, fitting_runs(0.0099995, 0), 0);
  EXPECT_FALSE(can_confirm(hopeless));
  EXPECT_FALSE(allowed_failures(100000, hopeless));
  EXPECT_THROW(confirming_runs(0, hopeless), Refused);
}

TEST(JudgeConfirmation, GivesTheYieldOfAllCages) {
  StudyData study = plain_study(1000, "random");
  study.plan.redraw_jams = true;
  study.plan.limits = {{"badness", {}, 0.0, "test", 1}};
  study.quantities = {{"badness", "-", "test", std::vector<double>(1000, -1)}};
  study.jam.candidate = {0.004};
  study.quantities[0].values[7] = 1;
  const Confirmation result = judge_confirmation(study, {0.98, 0.95, 1, 0});
  EXPECT_TRUE(result.passed);
  EXPECT_DOUBLE_EQ(result.yield.if_unknown_fail, 0.996 * 0.999);
  EXPECT_DOUBLE_EQ(result.yield.lower_bound,
                   (0.996 - 1e-6) * clopper_pearson_lower(999, 1000, 0.95));
  EXPECT_DOUBLE_EQ(result.yield.fits, 0.996);
}

TEST(AllowedFailures, AreWhatTheExactBoundAllows) {
  for (const double target : {0.5, 0.9, 0.99})
    for (const std::size_t attempts : {1, 2, 5}) {
      const ConfirmationRules rules{target, 0.95, attempts, 0};
      for (const std::size_t runs : {5, 60, 300, 1000, 4000}) {
        const auto bound = [&](std::size_t failures) {
          return clopper_pearson_lower(static_cast<double>(runs - failures),
                                       static_cast<double>(runs), attempt_confidence(rules));
        };
        const auto failures = allowed_failures(runs, rules);
        if (!failures) {
          EXPECT_LT(bound(0), target);
          continue;
        }
        EXPECT_GE(bound(*failures), target);
        EXPECT_LT(bound(*failures + 1), target);
      }
    }
}

TEST(ConfirmingProbability, AtTheTargetIsAtMostTheErrorOfAnAttempt) {
  const ConfirmationRules rules{0.95, 0.95, 2, 0};
  double largest = 0;
  for (std::size_t runs = 1; runs <= 1500; ++runs) {
    const double probability = confirming_probability(0.95, runs, rules);
    EXPECT_LE(probability, 0.025) << runs;
    largest = std::max(largest, probability);
  }
  EXPECT_GT(largest, 0.0245);  // no more cautious than it must be
}

TEST(ConfirmationSize, GivesTheWantedPowerWithTheFewestRuns) {
  const ConfirmationRules rules{0.95, 0.95, 2, 5000};
  const std::size_t runs = confirmation_size(0.98, rules);
  EXPECT_GE(confirming_probability(0.98, runs, rules), kWantedPower);
  for (std::size_t fewer = 1; fewer < runs; ++fewer)
    EXPECT_LT(confirming_probability(0.98, fewer, rules), kWantedPower) << fewer;
  EXPECT_EQ(confirmation_size(1.0, rules), confirming_runs(0, rules));
}

TEST(ConfirmationSize, KeepsToTheMostRuns) {
  const ConfirmationRules rules{0.95, 0.95, 2, 200};
  const std::size_t runs = confirmation_size(0.951, rules);
  EXPECT_LE(runs, 200u);
  EXPECT_GT(confirming_runs(*allowed_failures(runs, rules) + 1, rules), 200u);
  EXPECT_EQ(confirmation_size(0.9, {0.95, 0.95, 2, 10}), confirming_runs(0, rules));
}

TEST(JudgeConfirmation, CountsJamsAndLostRunsAsFailing) {
  StudyData study = plain_study(100);
  study.plan.limits = {{"q", {}, 1.0, "test", 1}};
  study.quantities = {{"q", "-", "test", std::vector<double>(100, 0.5)}};
  const ConfirmationRules rules{0.95, 0.95, 1, 0};  // 100 runs may have one failure
  EXPECT_TRUE(judge_confirmation(study, rules).passed);
  study.status[3] = RunStatus::jammed;
  EXPECT_TRUE(judge_confirmation(study, rules).passed);
  for (const RunStatus lost : {RunStatus::failed, RunStatus::jammed, RunStatus::censored}) {
    study.status[7] = lost;
    const Confirmation result = judge_confirmation(study, rules);
    EXPECT_FALSE(result.passed);
    EXPECT_EQ(result.meeting, 98u);
    EXPECT_EQ(result.unknown, lost == RunStatus::jammed ? 0u : 1u);
    EXPECT_NEAR(result.yield.lower_bound, clopper_pearson_lower(98, 100, 0.95), 1e-12);
  }
}

TEST(JudgeConfirmation, RefusesDependentRuns) {
  EXPECT_THROW(judge_confirmation(plain_study(100, "sobol"), {}), Refused);
  EXPECT_THROW(judge_confirmation(plain_study(100, "random", 4), {}), Refused);
}

/// Attempts of 60 runs each, at a target of 90 %: so many fail.
std::vector<StudyData> attempts_of(const std::vector<int>& failures, std::size_t shares) {
  std::vector<StudyData> attempts;
  for (const int failing : failures) {
    StudyData study = plain_study(60);
    study.plan.target_yield = 0.9;
    study.plan.campaign.attempts = shares;
    study.plan.limits = {{"q", {}, 1.0, "test", 1}};
    study.quantities = {{"q", "-", "test", std::vector<double>(60, 0.5)}};
    std::fill_n(study.quantities[0].values.begin(), failing, 2.0);
    attempts.push_back(study);
  }
  return attempts;
}

TEST(JudgeAttempts, BoundsASequenceByItsLeast) {
  const auto bound = [](int failing, double confidence) {
    return clopper_pearson_lower(60 - failing, 60, confidence);
  };
  JudgedAttempts judged = judge_attempts(attempts_of({0, 1}, 1));
  EXPECT_EQ(judged.decisive, 1u);
  EXPECT_NEAR(judged.lower_bound, bound(1, 0.95), 1e-12);
  judged = judge_attempts(attempts_of({1, 0}, 1));
  EXPECT_NEAR(judged.lower_bound, bound(1, 0.95), 1e-12);
  judged = judge_attempts(attempts_of({0, 9}, 1));  // the next did not confirm
  EXPECT_EQ(judged.decisive, 0u);
  EXPECT_DOUBLE_EQ(judged.lower_bound, 0.9);
  judged = judge_attempts(attempts_of({9, 0}, 2));  // each has half of the error
  EXPECT_EQ(judged.decisive, 1u);
  EXPECT_NEAR(judged.lower_bound, bound(0, 0.975), 1e-12);
  judged = judge_attempts(attempts_of({9, 8}, 2));
  EXPECT_EQ(judged.decisive, 1u);
  EXPECT_NEAR(judged.lower_bound, bound(8, 0.975), 1e-12);
}

TEST(IsComplete, WithAllRunsOrTheAllowedFailuresUsedUp) {
  StudyData attempt = attempts_of({2}, 1).front();
  attempt.design.samples_planned = 60;
  EXPECT_TRUE(is_complete(attempt));
  attempt.design.samples_planned = 76;  // one may fail of 46, two of 61, three of 76
  EXPECT_FALSE(is_complete(attempt));
  attempt.design.samples_planned = 61;
  EXPECT_FALSE(is_complete(attempt));
  EXPECT_TRUE([&] {
    StudyData over = attempts_of({3}, 1).front();
    over.design.samples_planned = 61;
    return is_complete(over);
  }());
}

TEST(SurestAttempt, IsTheOnePassedOrTheOneWithTheHighestBound) {
  const auto attempt = [](double lower_bound, bool passed) {
    Confirmation confirmation;
    confirmation.yield.lower_bound = lower_bound;
    confirmation.passed = passed;
    return confirmation;
  };
  EXPECT_EQ(surest_attempt({attempt(0.9, false), attempt(0.93, false), attempt(0.92, false)}), 1u);
  EXPECT_EQ(surest_attempt({attempt(0.97, false), attempt(0.96, true)}), 1u);
  EXPECT_EQ(surest_attempt({attempt(0.99, true), attempt(0.96, true), attempt(0.8, false)}), 1u);
}

}  // namespace
}  // namespace cagetol
