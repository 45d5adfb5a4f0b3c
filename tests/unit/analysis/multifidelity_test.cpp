#include "analysis/fidelity/multifidelity.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "distributions/random_stream.hpp"
#include "tests/support/not_a_number.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;

/// Normal models with these correlations to the first; f_i has mean i and standard deviation i + 1.
struct Levels {
  std::vector<double> correlation, cost;

  double value(std::size_t model, std::uint64_t repeat, std::size_t sample) const {
    RandomStream draws(3, Purpose::noise, repeat, static_cast<std::uint32_t>(sample));
    const double first = gsl_cdf_ugaussian_Pinv(draws.next());
    double own = 0;
    for (std::size_t i = 0; i < model; ++i) own = gsl_cdf_ugaussian_Pinv(draws.next());
    const double r = correlation[model], i = static_cast<double>(model);
    return i + (i + 1) * (r * first + std::sqrt(1 - r * r) * own);
  }
  std::vector<std::vector<double>> samples(const std::vector<std::size_t>& models,
                                           const std::vector<std::size_t>& counts,
                                           std::uint64_t repeat) const {
    std::vector<std::vector<double>> values(models.size());
    for (std::size_t i = 0; i < models.size(); ++i)
      for (std::size_t k = 0; k < counts[i]; ++k) values[i].push_back(value(models[i], repeat, k));
    return values;
  }
  MultifidelityPlan plan(std::size_t pilot, std::uint64_t repeat = 1'000'000) const {
    std::vector<std::size_t> all(cost.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return plan_multifidelity(samples(all, std::vector(all.size(), pilot), repeat), cost);
  }
};

/// Variance of plain Monte Carlo at the same cost over the scatter of the estimator in repeats, and
/// the mean square of the standard errors that it states over that scatter.
struct Scatter {
  double gain = 0, bias_in_errors = 0, stated = 0;
};
Scatter achieved(const Levels& models, const MultifidelityPlan& plan, double cost) {
  constexpr int kRepeats = 1000;
  const auto counts = multifidelity_counts(plan, models.cost, cost);
  double spent = 0, sum = 0, squares = 0, stated = 0;
  for (std::size_t i = 0; i < counts.size(); ++i)
    spent += static_cast<double>(counts[i]) * models.cost[plan.models[i]];
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    const MultifidelityMean mean = multifidelity_mean(
        plan, models.samples(plan.models, counts, static_cast<std::uint64_t>(repeat)));
    sum += mean.value;
    squares += mean.value * mean.value;
    stated += mean.standard_error * mean.standard_error;
  }
  const double centre = sum / kRepeats, variance = squares / kRepeats - centre * centre;
  return {models.cost[0] / spent / variance, centre / std::sqrt(variance / kRepeats),
          stated / kRepeats / variance};
}

TEST(Multifidelity, GainByHand) {
  // r^2 = 0.9025, cost 1 %: gain = 1 / (sqrt(0.0975) + 0.1 * 0.95)^2 = 6.03;
  // m_2 / m_1 = sqrt(0.9025 / (0.01 * 0.0975)) = 30.4.
  const Levels models{{1, 0.95}, {1, 0.01}};
  const MultifidelityPlan plan = models.plan(200000);
  EXPECT_NEAR(plan.gain, 6.03, 0.05);
  EXPECT_NEAR(plan.ratios[1], 30.4, 0.3);
  EXPECT_NEAR(plan.weights[1], 0.475, 0.005);
  const auto counts = multifidelity_counts(plan, models.cost, 1304);
  EXPECT_NEAR(static_cast<double>(counts[0]), 1000, 5);
  EXPECT_NEAR(static_cast<double>(counts[1]), 30400, 300);
}

TEST(Multifidelity, PredictedAndAchievedGainAgree) {
  for (const Levels& models :
       {Levels{{1, 0.95}, {1, 0.05}}, Levels{{1, -0.9}, {1, 0.02}},
        Levels{{1, 0.97, 0.9}, {1, 0.1, 0.005}}, Levels{{1, 0.8, 0.95}, {1, 0.01, 0.1}}}) {
    const MultifidelityPlan plan = models.plan(400);  // as large as a real pilot
    ASSERT_GT(plan.models.size(), 1u);
    const Scatter seen = achieved(models, plan, 40);
    EXPECT_NEAR(seen.gain / plan.gain, 1, 0.25) << plan.gain;
    EXPECT_LT(std::abs(seen.bias_in_errors), 4);
    EXPECT_NEAR(seen.stated, 1, 0.15);
  }
}

TEST(Multifidelity, IsLeftAloneWhereItGainsLittle) {
  EXPECT_THAT((Levels{{1, 0.3}, {1, 0.2}}.plan(1000).models), ElementsAre(0));
  EXPECT_THAT((Levels{{1, 0.99}, {1, 0.9}}.plan(1000).models), ElementsAre(0));
  // 1 / (sqrt(0.51) + sqrt(0.1 * 0.49))^2 = 1.14 is not worth it.
  EXPECT_THAT((Levels{{1, 0.7}, {1, 0.1}}.plan(4000).models), ElementsAre(0));
  // A model that is dearer and knows less than another takes no part.
  EXPECT_THAT((Levels{{1, 0.95, 0.5}, {1, 0.01, 0.05}}.plan(2000).models), ElementsAre(0, 1));
  EXPECT_EQ((Levels{{1, 0.3}, {1, 0.2}}.plan(1000).gain), 1);
}

TEST(Multifidelity, SamplesWithoutAValueLeaveTheTermsThatNeedThem) {
  const MultifidelityPlan plan{{0, 1}, {1, 2}, {1, 0.5}, 2};
  // (1 - 0.5 * 2) and (3 - 0.5 * 2) without the failed ones, plus 0.5 * mean(2, 2, 6, 2).
  const std::vector<std::vector<double>> values = {{1, 3, kNan, 7}, {2, 2, 6, kNan, 2}};
  const MultifidelityMean mean = multifidelity_mean(plan, values);
  EXPECT_DOUBLE_EQ(mean.value, 1 + 0.5 * 3);
  EXPECT_EQ(mean.lost, 3u);
}

TEST(Multifidelity, NeedsAPilotOfSixteenSamplesWithAllValues) {
  std::vector<std::vector<double>> pilot(2);
  for (int k = 0; k < 16; ++k) {
    pilot[0].push_back(k);
    pilot[1].push_back(k + 0.1 * (k % 3));
  }
  const std::vector<double> costs = {1, 0.01};
  EXPECT_GT(plan_multifidelity(pilot, costs).gain, 10);
  pilot[1][4] = kNan;
  EXPECT_EQ(plan_multifidelity(pilot, costs).gain, 1);
}

}  // namespace
}  // namespace cagetol
