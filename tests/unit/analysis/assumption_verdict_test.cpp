#include "analysis/tolerance/assumption_verdict.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "analysis/statistics/binomial_bounds.hpp"
#include "analysis/study/refused.hpp"
#include "analysis/tolerance/assumption_plan.hpp"
#include "distributions/basics/random_stream.hpp"
#include "tests/support/synthetic_study.hpp"
#include "tests/support/tolerance_standin.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;

/// Cages of one tolerance, of which this share meets the limit.
StudyData cages(std::int64_t runs, std::int64_t seed, double yield, double target = 0.95) {
  StandinDimension width = kPrintedWidth;
  width.scales = {0.9};
  const double widest = 0.009 * gsl_cdf_ugaussian_Pinv(std::pow(yield, 1.0 / 13));
  return tolerance_standin(runs, seed, {width}, target, [&](const StandinCage& cage) {
    return widest_pocket(cage) + 0.026 - widest;
  });
}

/// So many runs that meet the limit, then those that do not, then those without a result.
StudyData counted(std::size_t meeting, std::size_t missing, std::size_t lost = 0) {
  StudyData study = cages(static_cast<std::int64_t>(meeting + missing + lost), 1, 0.9);
  for (std::size_t i = 0; i < study.size(); ++i) {
    study.quantities[0].values[i] = i < meeting ? -1 : 1;
    if (i >= meeting + missing) study.status[i] = RunStatus::failed;
  }
  return study;
}

const ConfirmationRules kRules{0.95, 0.95, 1, 0};

TEST(AssumptionVerdict, HoldsFailsOrIsNotResolvedByExactBounds) {
  const StudyData confirming = counted(200, 0);
  const AssumptionVerdicts all =
      judge_assumptions(confirming, {counted(200, 0), counted(150, 50), counted(190, 10)}, kRules);
  ASSERT_EQ(all.alternatives.size(), 3u);
  EXPECT_EQ(all.alternatives[0].answer, AssumptionAnswer::holds);
  EXPECT_EQ(all.alternatives[1].answer, AssumptionAnswer::fails);
  EXPECT_EQ(all.alternatives[2].answer, AssumptionAnswer::not_resolved);
  EXPECT_EQ(all.holding, 1u);
  EXPECT_EQ(all.failing, 1u);
  EXPECT_EQ(all.unresolved, 1u);
  EXPECT_THAT(all.threats, ElementsAre(1, 2));
  EXPECT_DOUBLE_EQ(all.alternatives[0].lower_bound, clopper_pearson_lower(200, 200, 0.95));
  // Three alternatives share the error of "fails".
  EXPECT_DOUBLE_EQ(all.alternatives[1].upper_bound, clopper_pearson_upper(150, 200, 1 - 0.05 / 3));
  EXPECT_FALSE(all.alternatives[0].named);
  EXPECT_TRUE(all.alternatives[1].named);
  EXPECT_EQ(all.alternatives[1].change.lost, 50u);
  EXPECT_EQ(all.alternatives[0].quantities.at(0).quantity, "badness");
  EXPECT_DOUBLE_EQ(all.alternatives[1].quantities[0].paired.difference.value, 0.5);
}

TEST(AssumptionVerdict, LostRunsDoNotHoldAndDoNotFail) {
  const AssumptionVerdicts all =
      judge_assumptions(counted(200, 0), {counted(150, 0, 50), counted(100, 50, 50)}, kRules);
  EXPECT_EQ(all.alternatives[0].answer, AssumptionAnswer::not_resolved);
  EXPECT_EQ(all.alternatives[0].runs_needed, 0u);
  EXPECT_EQ(all.alternatives[0].unknown, 50u);
  EXPECT_EQ(all.alternatives[1].answer, AssumptionAnswer::fails);
}

TEST(AssumptionVerdict, SharesItsErrorWithOtherAttempts) {
  ConfirmationRules rules = kRules;
  rules.attempts = 2;
  const AssumptionVerdicts all = judge_assumptions(counted(100, 0), {counted(100, 0)}, rules);
  EXPECT_DOUBLE_EQ(all.alternatives[0].lower_bound, clopper_pearson_lower(100, 100, 0.975));
  // Seven losses: p = 2 / 2^7, above 0.05 / 2 / 2 of the smaller of two.
  const auto named = [&](std::size_t losses, std::size_t alternatives) {
    return judge_assumptions(counted(100, 0),
                             std::vector<StudyData>(alternatives, counted(100 - losses, losses)),
                             rules)
        .alternatives[0]
        .named;
  };
  EXPECT_TRUE(named(7, 1));
  EXPECT_FALSE(named(7, 2));
  EXPECT_TRUE(named(8, 2));
}

TEST(AssumptionVerdict, PairsAreThoseOfTheSameCages) {
  // More runs than the attempt: all count for the yield, the pairs alone for its change.
  const AssumptionVerdicts all =
      judge_assumptions(cages(300, 7, 0.97), {cages(900, 7, 0.97)}, kRules);
  EXPECT_EQ(all.alternatives[0].runs, 900u);
  EXPECT_EQ(all.alternatives[0].change.pairs, 300u);
  EXPECT_EQ(all.alternatives[0].change.gained + all.alternatives[0].change.lost, 0u);
  const Estimate& same = all.alternatives[0].quantities[0].paired.difference;
  EXPECT_EQ(same.value, 0);
  EXPECT_EQ(same.upper - same.lower, 0);
  StudyData lots = cages(300, 7, 0.97);
  lots.lot[1] = lots.lot[0];
  EXPECT_THROW(judge_assumptions(lots, {cages(300, 7, 0.97)}, kRules), Refused);
  EXPECT_TRUE(judge_assumptions(cages(300, 7, 0.97), {}, kRules).alternatives.empty());
}

TEST(SettlingRuns, SettleWithTheWantedPower) {
  // None may fail of 59: 0.95^59 <= 0.05.
  EXPECT_EQ(settling_runs(1, 0.95, 0.95, 0.95), 59u);
  EXPECT_EQ(settling_runs(0.95, 0.95, 0.95, 0.95), 0u);
  const std::size_t above = settling_runs(0.97, 0.95, 0.95, 0.95),
                    below = settling_runs(0.93, 0.95, 0.95, 0.99);
  // The normal approximation: ((z_a s_0 + z_b s_1) / 0.02)^2.
  EXPECT_NEAR(static_cast<double>(above), 832, 83);
  EXPECT_NEAR(static_cast<double>(below), 1736, 173);
  int settled = 0;
  for (int seed = 1; seed <= 400; ++seed) {
    const StudyData runs = cages(static_cast<std::int64_t>(above), seed, 0.97);
    settled +=
        judge_assumptions(runs, {runs}, kRules).alternatives[0].answer == AssumptionAnswer::holds;
  }
  EXPECT_GE(settled, 0.86 * 400);
  EXPECT_LE(settled, 0.95 * 400);
}

/// Share of 300 alternatives with this yield that the automatic number of runs settles, planned from
/// the yield of an attempt of 400 runs.
double settled_automatically(double yield, double attempt_yield) {
  const ConfirmationRules rules{0.9, 0.95, 1, 0};
  AssumptionPlan plan;
  plan.confirming = confirming_runs(0, rules);
  plan.settling = settling_runs(attempt_yield, 0.9, 0.95, 0.95);
  const auto count = static_cast<std::int64_t>(automatic_runs(plan));
  double settled = 0;
  for (int seed = 1; seed <= 300; ++seed) {
    const StudyData runs = cages(count, seed, yield);
    settled += judge_assumptions(runs, {runs}, rules).alternatives[0].answer !=
               AssumptionAnswer::not_resolved;
  }
  return settled / 300;
}

TEST(SettlingRuns, AreTheAutomaticNumber) {
  // 29 runs, which confirm if none fails, settle 0.94^29 = 17 %.
  EXPECT_GE(settled_automatically(0.94, 0.94), 0.86);
  EXPECT_GE(settled_automatically(0.99, 0.99), 0.86);
  EXPECT_GE(settled_automatically(0.85, 0.85), 0.86);
  AssumptionPlan plan;
  plan.confirming = 29;
  for (const auto& [settling, automatic] :
       {std::pair{0u, 29u}, {20u, 29u}, {400u, 400u}, {2900u, 2900u}, {2901u, 29u}}) {
    plan.settling = settling;
    EXPECT_EQ(automatic_runs(plan), automatic);
  }
}

TEST(SettlingRuns, TheSmallNumberIsOnOffer) {
  AssumptionPlan plan;
  plan.attempt = 1;
  plan.confirming = 29;
  plan.settling = 400;
  plan.alternatives.resize(2);
  const std::string text = assumption_plan_text(plan);
  EXPECT_THAT(text, testing::HasSubstr("auto does it, 400 runs under each of 2 alternatives"));
  EXPECT_THAT(
      text, testing::HasSubstr("assumption_samples=29 settles those that never fail, by 29 runs"));
}

/// The widest pocket that this share of the cages keeps, in mm.
double widest_of(double yield) {
  return 0.009 * gsl_cdf_ugaussian_Pinv(std::pow(yield, 1.0 / 13));
}

/// An attempt with eight alternatives on its cages. Every run has noise of its own, which moves
/// some cages across the limit.
struct Campaigns {
  double yield = 0.97, target = 0.95;
  std::int64_t pairs = 1000;
  double noise_mm = 0.001;
  double loss = 0.02;   ///< of the yield under the first alternative
  bool chosen = false;  ///< up to two attempts, judged is the one that passes

  static constexpr std::size_t kAlternatives = 8;

  StudyData runs(const StudyData& bare, std::uint64_t seed, std::uint32_t stream,
                 double limit) const {
    StudyData study = bare;
    for (std::size_t i = 0; i < study.size(); ++i) {
      RandomStream noise(seed, Purpose::noise, i, stream);
      study.quantities[0].values[i] += noise_mm * gsl_cdf_ugaussian_Pinv(noise.next()) - limit;
    }
    return study;
  }

  AssumptionVerdicts judge(std::int64_t seed) const {
    StandinDimension width = kPrintedWidth;
    width.scales = {0.9};
    const ConfirmationRules rules{target, 0.95, chosen ? 2u : 1u, 0};
    for (std::int64_t attempt = 0;; ++attempt) {
      const std::int64_t own = 2 * seed + attempt;
      const auto stream = static_cast<std::uint64_t>(own);
      const StudyData bare = tolerance_standin(pairs, own, {width}, target, [](const auto& cage) {
        return widest_pocket(cage) + 0.026;
      });
      const StudyData confirming = runs(bare, stream, 0, widest_of(yield));
      if (chosen && attempt == 0 && !judge_confirmation(confirming, rules).passed) continue;
      std::vector<StudyData> alternatives;
      for (std::uint32_t k = 0; k < kAlternatives; ++k)
        alternatives.push_back(runs(bare, stream, k + 1, widest_of(k == 0 ? yield - loss : yield)));
      return judge_assumptions(confirming, alternatives, rules);
    }
  }

  struct Rates {
    double named = 0, false_alarms = 0, change = 0, differing = 0;
  };
  Rates rates(int repeats) const {
    Rates found;
    for (int repeat = 1; repeat <= repeats; ++repeat) {
      const AssumptionVerdicts verdicts = judge(repeat);
      const auto& moved = verdicts.alternatives[0];
      found.change += moved.change.change.value / repeats;
      found.differing += static_cast<double>(verdicts.alternatives[1].change.gained +
                                             verdicts.alternatives[1].change.lost) /
                         repeats;
      found.named += moved.named ? 1.0 / repeats : 0;
      bool alarm = loss == 0 && moved.named;
      for (std::size_t k = 1; k < kAlternatives; ++k)
        alarm = alarm || verdicts.alternatives[k].named;
      found.false_alarms += alarm ? 1.0 / repeats : 0;
    }
    std::printf(
        "%ld pairs, %d repeats: yield moved by %.4f, named %.4f, false alarms %.4f; %.1f "
        "pairs differ by noise\n",
        static_cast<long>(pairs), repeats, found.change, found.named, found.false_alarms,
        found.differing);
    return found;
  }
};

TEST(AssumptionVerdict, NamesWhatMovesTheYieldByTwoPercent) {
  const auto found = Campaigns{}.rates(400);
  EXPECT_NEAR(found.change, -0.02, 0.001);
  EXPECT_GE(found.named, 0.95);
  EXPECT_LE(found.false_alarms, 0.05);
}

TEST(AssumptionVerdict, RaisesNoFalseAlarmsWhereTheAttemptIsChosenForPassing) {
  const auto found =
      Campaigns{.yield = 0.98, .pairs = 400, .noise_mm = 0.005, .loss = 0, .chosen = true}.rates(
          400);
  EXPECT_LE(found.false_alarms, 0.05);
}

}  // namespace
}  // namespace cagetol
