#include "analysis/fidelity/control_variate.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>
#include <gtest/gtest.h>

#include <cmath>

#include "distributions/random_stream.hpp"
#include "tests/support/not_a_number.hpp"

namespace cagetol {
namespace {

constexpr double kMean = 3, kDeviation = 2;
const std::vector<Limit> kLimits = {
    {.quantity = "q", .minimum = {}, .maximum = kMean + kDeviation, .source = "test"}};

/// Two normal models with this correlation; the expensive one has mean 3 and standard deviation 2.
struct TwoModels {
  double correlation, cost;
  double lost = 0;  ///< share of runs without a value, on each model by itself

  struct Runs {
    std::vector<double> expensive, cheap;
    operator PairedRuns() const { return {expensive, cheap}; }
  };
  Runs draw(std::size_t n, std::size_t m, std::uint64_t repeat) const {
    Runs runs;
    for (std::size_t k = 0; k < m; ++k) {
      RandomStream draws(5, Purpose::noise, repeat, static_cast<std::uint32_t>(k));
      const auto normal = [&] { return gsl_cdf_ugaussian_Pinv(draws.next()); };
      const double f = normal(), own = normal();
      const bool f_lost = draws.next() < lost, g_lost = draws.next() < lost;
      if (k < n) runs.expensive.push_back(f_lost ? kNan : kMean + kDeviation * f);
      const double r = correlation;
      runs.cheap.push_back(g_lost ? kNan : 7 - 5 * (r * f + std::sqrt(1 - r * r) * own));
    }
    return runs;
  }
};

constexpr std::uint64_t kPilot = 1'000'000;

double truth(HelpedStatistic statistic) {
  if (statistic == HelpedStatistic::yield) return gsl_cdf_ugaussian_P(1);
  return statistic == HelpedStatistic::mean ? kMean : kDeviation;
}

/// Over repeats: gain at equal cost, bias in standard errors, and the mean square of the stated
/// standard errors over the scatter.
struct Achieved {
  double gain, bias, stated;
};
Achieved achieved(HelpedStatistic statistic, const TwoModels& models, std::size_t n,
                  std::size_t m) {
  constexpr int kRepeats = 800;
  std::vector<double> helped, plain;
  double squares = 0;
  for (std::uint64_t repeat = 0; repeat < kRepeats; ++repeat) {
    const auto estimate = helped_estimate(statistic, models.draw(n, m, repeat), kLimits);
    helped.push_back(estimate.value);
    plain.push_back(estimate.plain);
    squares += estimate.standard_error * estimate.standard_error / kRepeats;
  }
  const double variance = gsl_stats_variance(helped.data(), 1, kRepeats);
  const double share = 1 + models.cost * static_cast<double>(m) / static_cast<double>(n);
  return {gsl_stats_variance(plain.data(), 1, kRepeats) / share / variance,
          (gsl_stats_mean(helped.data(), 1, kRepeats) - truth(statistic)) /
              std::sqrt(variance / kRepeats),
          squares / variance};
}

TEST(ControlVariate, PredictedAndAchievedGainAgree) {
  for (const TwoModels& models :
       {TwoModels{0.98, 0.01}, TwoModels{-0.995, 0.01}, TwoModels{0.95, 0.05}})
    for (const HelpedStatistic statistic :
         {HelpedStatistic::mean, HelpedStatistic::deviation, HelpedStatistic::yield}) {
      const std::size_t n = 200;
      // So many pairs know the covariances.
      const double seen =
          helped_estimate(statistic, models.draw(40000, 40001, kPilot), kLimits).correlation;
      const auto m = static_cast<std::size_t>(static_cast<double>(n) *
                                              std::min(best_cheap_ratio(seen, models.cost), 30.0));
      const double predicted =
          gain_at_cost(seen, static_cast<double>(n), static_cast<double>(m), models.cost);
      const Achieved got = achieved(statistic, models, n, m);
      EXPECT_GT(predicted, 1.2);
      EXPECT_NEAR(got.gain / predicted, 1, 0.25)
          << helped_statistic_name(statistic) << " " << models.correlation << " " << predicted;
      EXPECT_NEAR(got.bias, 0, 4) << helped_statistic_name(statistic);
      EXPECT_NEAR(got.stated, 1, 0.2) << helped_statistic_name(statistic);
      // Data sets drawn again and again say the same on average; of 200 runs few are so near a
      // limit that they tell how well its yield is helped.
      double logs = 0;
      for (std::uint64_t set = 1; set <= 10; ++set)
        logs += std::log(resampled_gain(statistic, models.draw(n, m, kPilot + set), kLimits,
                                        models.cost, set, 100));
      EXPECT_NEAR(std::exp(logs / 10) / predicted, 1,
                  statistic == HelpedStatistic::yield ? 0.4 : 0.25)
          << helped_statistic_name(statistic);
    }
}

TEST(ControlVariate, RunsWithoutAValueLeaveTheTermsThatNeedThem) {
  const TwoModels models{0.98, 0.01, 0.05};
  for (const HelpedStatistic statistic :
       {HelpedStatistic::mean, HelpedStatistic::deviation, HelpedStatistic::yield}) {
    const HelpedEstimate one = helped_estimate(statistic, models.draw(200, 2000, 1), kLimits);
    EXPECT_GT(one.lost, 50u);
    EXPECT_LT(one.lost, 200u);
    const Achieved got = achieved(statistic, models, 200, 2000);
    EXPECT_GT(got.gain, 1.5) << helped_statistic_name(statistic);
    EXPECT_NEAR(got.bias, 0, 4) << helped_statistic_name(statistic);
    EXPECT_NEAR(got.stated, 1, 0.25) << helped_statistic_name(statistic);
  }
}

TEST(ControlVariate, ByHand) {
  // Gain at equal cost: r^2 = 0.96, M / N = 20, w = 0.01: 1 / (1.2 (1 - 0.96 * 0.95)).
  EXPECT_NEAR(gain_at_cost(std::sqrt(0.96), 100, 2000, 0.01), 1 / (1.2 * 0.088), 1e-9);
  EXPECT_EQ(gain_at_cost(kNan, 100, 2000, 0.01), 0);
  EXPECT_NEAR(best_cheap_ratio(std::sqrt(0.96), 0.01), std::sqrt(0.96 / 0.0004), 1e-9);
  EXPECT_EQ(best_cheap_ratio(0, 0.01), 1);
  // f = 2 g exactly: the mean of f is that of 2 g over all samples.
  std::vector<double> expensive, cheap;
  for (int k = 0; k < 40; ++k) {
    cheap.push_back(k * k % 17);
    if (k < 20) expensive.push_back(2 * cheap.back());
  }
  const HelpedEstimate mean = helped_estimate(HelpedStatistic::mean, {expensive, cheap}, {});
  EXPECT_NEAR(mean.value, 2 * gsl_stats_mean(cheap.data(), 1, 40), 1e-12);
  EXPECT_NEAR(mean.plain, gsl_stats_mean(expensive.data(), 1, 20), 1e-12);
  EXPECT_NEAR(mean.correlation, 1, 1e-12);
}

TEST(ControlVariate, SaysNothingWithoutScatterOrPairs) {
  const std::vector<double> few(15, 1.0), same(30, 1.0), none(30, kNan);
  for (const HelpedStatistic statistic :
       {HelpedStatistic::mean, HelpedStatistic::deviation, HelpedStatistic::yield}) {
    EXPECT_TRUE(std::isnan(helped_estimate(statistic, {few, few}, kLimits).value));
    EXPECT_TRUE(std::isnan(helped_estimate(statistic, {same, same}, kLimits).value));
    EXPECT_TRUE(std::isnan(helped_estimate(statistic, {none, same}, kLimits).value));
    EXPECT_TRUE(std::isnan(helped_estimate(statistic, {same, none}, kLimits).value));
    EXPECT_TRUE(std::isnan(resampled_gain(statistic, {same, none}, kLimits, 0.1, 1, 10)));
  }
}

}  // namespace
}  // namespace cagetol
