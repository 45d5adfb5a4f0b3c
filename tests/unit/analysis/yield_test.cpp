#include "analysis/statistics/yield.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

constexpr auto kMeets = Judgement::meets, kMisses = Judgement::misses,
               kUnknown = Judgement::unknown;

StudyData study_with_limit() {
  StudyData study = plain_study(6);
  study.plan.limits = {{"force", 1.0, 5.0, "test", 6}, {"slip", {}, 0.1, "test", 6}};
  study.quantities = {{"force", "N", "", {2, 6, 0.5, 3, NAN, 4}},
                      {"slip", "-", "", {0.05, 0.05, 0.05, 0.2, 0.05, 0.05}}};
  return study;
}

TEST(Judgement, LimitsJamsAndUnknowns) {
  StudyData study = study_with_limit();
  study.status[5] = RunStatus::jammed;
  EXPECT_EQ(judge(study, study.plan.limits[0]),
            (std::vector{kMeets, kMisses, kMisses, kMeets, kUnknown, kMisses}));
  EXPECT_EQ(judge_all(study), (std::vector{kMeets, kMisses, kMisses, kMisses, kUnknown, kMisses}));
  study.status[0] = RunStatus::failed;
  study.status[3] = RunStatus::censored;
  study.status[1] = RunStatus::poisoned;
  EXPECT_EQ(judge_all(study),
            (std::vector{kUnknown, kUnknown, kMisses, kUnknown, kUnknown, kMisses}));
  EXPECT_EQ(judge(study, study.plan.limits[0])[0], kUnknown);
  EXPECT_EQ(judge(study, study.plan.limits[0])[1], kUnknown);
}

TEST(Judgement, QuantityThatIsNotThereIsUnknown) {
  StudyData study = study_with_limit();
  study.plan.limits = {{"stress", {}, 5.0, "test", 6}};
  EXPECT_EQ(judge_all(study), std::vector<Judgement>(6, kUnknown));
}

TEST(Yield, CountsBothWaysWithExactBounds) {
  const StudyData study = plain_study(100);
  std::vector<Judgement> judgements(100, kMeets);
  judgements[3] = kMisses;
  judgements[4] = judgements[5] = kUnknown;
  const std::vector<double> equal(100, 1.0);
  const Yield yield = estimate_yield(study, judgements, equal, Resampling(study, 100), 0.95);
  EXPECT_DOUBLE_EQ(yield.if_unknown_fail, 0.97);
  EXPECT_DOUBLE_EQ(yield.if_unknown_pass, 0.99);
  EXPECT_NEAR(yield.lower_bound, 0.924289, 1e-6);  // Clopper-Pearson, 97 of 100
  EXPECT_NEAR(yield.upper_bound, 0.999487, 1e-6);  // 99 of 100
  EXPECT_DOUBLE_EQ(yield.ess, 100);
}

TEST(Yield, FailedRunsNeverRaiseIt) {
  const StudyData study = plain_study(400);
  std::vector<Judgement> judgements(400, kMeets);
  for (std::size_t i = 0; i < 400; i += 20) judgements[i] = kMisses;
  std::vector<double> weights(400);
  for (std::size_t i = 0; i < 400; ++i) weights[i] = 0.2 + static_cast<double>(i % 7) / 4;
  const Resampling resampling(study, 300);
  for (const auto& w : {std::vector<double>(400, 1.0), weights}) {
    const Yield before = estimate_yield(study, judgements, w, resampling, 0.95);
    for (const std::size_t lost :
         {1u, 40u, 77u}) {  // one that met the limits, one that missed, one more
      auto after_loss = judgements;
      after_loss[lost] = kUnknown;
      const Yield after = estimate_yield(study, after_loss, w, resampling, 0.95);
      EXPECT_LE(after.if_unknown_fail, before.if_unknown_fail);
      EXPECT_LE(after.lower_bound, before.lower_bound + 1e-12);
      EXPECT_GE(after.if_unknown_pass, before.if_unknown_pass);
      EXPECT_GE(after.upper_bound, before.upper_bound - 1e-12);
    }
  }
}

TEST(Yield, WeightedRunsWithoutFailureAreNotCertain) {
  const StudyData study = plain_study(200);
  std::vector<double> weights(200, 0.0);
  for (std::size_t i = 0; i < 200; i += 2) weights[i] = 2;
  std::vector<Judgement> judgements(200, kMeets);
  judgements[1] = kMisses;  // has no weight
  const Yield yield = estimate_yield(study, judgements, weights, Resampling(study, 100), 0.95);
  EXPECT_DOUBLE_EQ(yield.if_unknown_fail, 1);
  EXPECT_DOUBLE_EQ(yield.ess, 100);
  EXPECT_NEAR(yield.lower_bound, 0.970487, 1e-6);  // Clopper-Pearson, 100 of 100
}

TEST(Yield, DependentRunsGetWiderBounds) {
  const StudyData lots = plain_study(400, "random", 8), independent = plain_study(400);
  std::vector<Judgement> judgements(400, kMeets);
  for (std::size_t i = 0; i < 400; ++i)
    if ((i / 8) % 10 == 0) judgements[i] = kMisses;  // whole lots fail
  const std::vector<double> equal(400, 1.0);
  const Yield of_lots = estimate_yield(lots, judgements, equal, Resampling(lots, 400), 0.95);
  const Yield exact =
      estimate_yield(independent, judgements, equal, Resampling(independent, 400), 0.95);
  EXPECT_EQ(of_lots.if_unknown_fail, exact.if_unknown_fail);
  EXPECT_LT(of_lots.lower_bound, exact.lower_bound - 0.02);
  EXPECT_NE(of_lots.method, exact.method);
}

TEST(Yield, NoneWhereRowsDoNotFollowTheLaws) {
  for (const char* design : {"grid", "pick-freeze"}) {
    const StudyData study = plain_study(400, design);
    const std::vector<Judgement> judgements(400, Judgement::meets);
    const std::vector<double> equal(400, 1.0);
    const Yield yield = estimate_yield(study, judgements, equal, Resampling(study, 20), 0.95);
    EXPECT_TRUE(std::isnan(yield.if_unknown_fail) && std::isnan(yield.if_unknown_pass));
    EXPECT_TRUE(std::isnan(yield.lower_bound) && std::isnan(yield.upper_bound));
    EXPECT_EQ(yield.method, std::string("the rows of a `") + design +
                                "` design do not follow the laws of the inputs");
  }
}

}  // namespace
}  // namespace cagetol
