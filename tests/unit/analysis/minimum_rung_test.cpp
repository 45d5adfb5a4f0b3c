#include "analysis/fidelity/minimum_rung.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "distributions/basics/random_stream.hpp"
#include "tests/support/not_a_number.hpp"

namespace cagetol {
namespace {

/// A constructed hierarchy: rung r has the mean of the reference plus bias[r] and noise of its own.
struct Hierarchy {
  std::vector<double> bias;   ///< in budgets; the last one is the reference's 0
  std::vector<double> noise;  ///< standard deviation, in standard deviations of the quantity
};

std::vector<std::vector<double>> runs_of(const Hierarchy& models, double budget, int samples,
                                         std::uint64_t repeat) {
  std::vector<std::vector<double>> values(models.bias.size());
  for (int k = 0; k < samples; ++k) {
    RandomStream draws(1, Purpose::noise, repeat, static_cast<std::uint32_t>(k));
    const double x = gsl_cdf_ugaussian_Pinv(draws.next()), y = draws.next();
    const double shared = std::sqrt(0.5) * x + std::sqrt(6.0) * (y - 0.5);  // unit variance
    for (std::size_t r = 0; r < values.size(); ++r)
      values[r].push_back(shared + models.bias[r] * budget +
                          models.noise[r] * gsl_cdf_ugaussian_Pinv(draws.next()));
  }
  return values;
}

/// In how many of 200 repeats the ladder finds this rung.
int found(const Hierarchy& models, std::size_t planted, int samples) {
  const LadderRule rule{.study_samples = 100, .budget_share = 1};
  const double budget = 0.1;  // the quantity has the standard deviation 1
  int count = 0;
  for (std::uint64_t repeat = 0; repeat < 200; ++repeat)
    count += minimum_rung(runs_of(models, budget, samples, repeat), rule).minimum == planted;
  return count;
}

TEST(MinimumRung, RecoversThePlantedRung) {
  // The noise of a rung leaves its shift a standard error of a sixth of the budget.
  const std::vector<double> noise = {0.1, 0.1, 0.1, 0};
  EXPECT_GE(found({{0.1, 0.1, 0, 0}, noise}, 0, 36), 190);
  EXPECT_GE(found({{-5, 0.2, 0, 0}, noise}, 1, 36), 190);
  EXPECT_GE(found({{9, -3, 0.2, 0}, noise}, 2, 36), 190);
  EXPECT_GE(found({{30, 9, 3, 0}, noise}, 3, 36), 190);
}

TEST(MinimumRung, SeldomCallsABiasedRungAdequate) {
  // At 1.2 budgets the right answer is the reference, or that the samples do not tell.
  EXPECT_LE(found({{1.2, 0}, {0.1, 0}}, 0, 36), 5);
  EXPECT_LE(found({{1.2, 0}, {0.1, 0}}, 0, 400), 0);
}

TEST(MinimumRung, SaysWhenSamplesDoNotTell) {
  const Hierarchy chaotic{{0, 0.5, 0}, {1, 1, 0}};
  const auto values = runs_of(chaotic, 0.1, 24, 3);
  const QuantityLadder ladder = minimum_rung(values, {.study_samples = 100, .budget_share = 1});
  EXPECT_FALSE(ladder.minimum);
  for (int r = 0; r < 2; ++r) {
    EXPECT_EQ(ladder.rungs[r].verdict, RungVerdict::unresolved);
    // Half width t(23) / sqrt(24) = 0.42 for a budget of 0.1.
    EXPECT_NEAR(ladder.rungs[r].pairs_needed, 24 * 4.2 * 4.2, 300);
    EXPECT_NEAR(ladder.rungs[r].correlation, std::sqrt(0.5), 0.25);
  }
  EXPECT_EQ(minimum_rung_for_all(std::vector{ladder}), 2u);
}

TEST(MinimumRung, ByHand) {
  // Reference 1, 2, 3: s = 1; budget 0.5 / sqrt(25) = 0.1. Shift 0.01 +- 0, then 0.2 +- 0.
  const std::vector<std::vector<double>> values = {{1.2, 2.2, 3.2}, {1.01, 2.01, 3.01}, {1, 2, 3}};
  const QuantityLadder ladder = minimum_rung(values, {.study_samples = 25, .budget_share = 0.5});
  EXPECT_DOUBLE_EQ(ladder.budget, 0.1);
  EXPECT_DOUBLE_EQ(ladder.mean, 2);
  EXPECT_NEAR(ladder.rungs[0].shift.value, 0.2, 1e-12);
  EXPECT_EQ(ladder.rungs[0].verdict, RungVerdict::biased);
  EXPECT_EQ(ladder.rungs[1].verdict, RungVerdict::adequate);
  EXPECT_NEAR(ladder.rungs[1].correlation, 1, 1e-12);
  EXPECT_EQ(ladder.minimum, 1u);
}

TEST(MinimumRung, ARungThatLosesRunsIsUnusable) {
  std::vector<double> reference, lossy, sound;
  for (int k = 0; k < 100; ++k) {
    reference.push_back(std::sin(k));
    sound.push_back(k == 7 ? kNan : reference.back());
    lossy.push_back(k % 20 == 3 ? kNan : reference.back());
  }
  const QuantityLadder ladder =
      minimum_rung(std::vector{lossy, sound, reference}, {.study_samples = 100});
  EXPECT_EQ(ladder.rungs[0].verdict, RungVerdict::unusable);
  EXPECT_EQ(ladder.rungs[0].lost, 5u);
  EXPECT_EQ(ladder.rungs[1].lost, 1u);
  EXPECT_EQ(ladder.minimum, 1u);
  // A quantity that only the reference has needs the reference.
  const std::vector<double> none(100, kNan);
  EXPECT_EQ(minimum_rung(std::vector{none, reference}, {.study_samples = 100}).minimum, 1u);
  EXPECT_FALSE(minimum_rung(std::vector{none, none}, {.study_samples = 100}).minimum);
}

TEST(MinimumRung, ForAllQuantitiesIsNotTheLargestOfTheirs) {
  const std::vector<double> x = {1, 2, 3, 4}, off = {3, 4, 5, 6};
  const LadderRule rule{.study_samples = 100};
  const std::vector<QuantityLadder> both = {
      minimum_rung(std::vector{x, off, x, x}, rule),  // rung 0 by chance, not rung 1
      minimum_rung(std::vector{off, x, x, x}, rule)};
  EXPECT_EQ(both[0].minimum, 0u);
  EXPECT_EQ(both[1].minimum, 1u);
  EXPECT_EQ(minimum_rung_for_all(both), 2u);
}

}  // namespace
}  // namespace cagetol
