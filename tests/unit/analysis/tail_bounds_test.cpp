#include "analysis/statistics/tail_bounds.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

/// n values with mean 0 and standard deviation 1.
std::vector<double> standard_values(int n) {
  std::vector<double> values;
  double sum = 0, squares = 0;
  for (int k = 0; k < n; ++k) {
    values.push_back(gsl_cdf_ugaussian_Pinv((k + 0.5) / n));
    sum += values.back();
  }
  for (double& x : values) squares += (x - sum / n) * (x - sum / n);
  for (double& x : values) x = (x - sum / n) / std::sqrt(squares / (n - 1));
  return values;
}

TEST(TailBounds, NormalBoundIsThatOfTheTables) {
  // One-sided tolerance factors, Hahn & Meeker table A.12: k(n, share, confidence).
  struct Factor {
    int n;
    double share, confidence, k;
  };
  for (const Factor& f :
       {Factor{10, 0.95, 0.95, 2.911}, Factor{20, 0.95, 0.95, 2.396}, Factor{30, 0.99, 0.95, 3.064},
        Factor{10, 0.90, 0.90, 2.066}, Factor{10, 0.99, 0.99, 5.074}})
    EXPECT_NEAR(normal_tail_bound(standard_values(f.n), f.k, f.confidence), 1 - f.share,
                2e-3 * (1 - f.share))
        << f.n;
}

TEST(TailBounds, ExponentialBoundByHand) {
  // Outer quarter of 8: 7 and 9 over 4, mean excess 4; chi2_{0.05}(4) = 0.710723.
  const std::vector<double> values = {1, 9, 2, 3, 4, 7, 0, 1};
  EXPECT_NEAR(exponential_tail_bound(values, 60, 0.95), 0.25 * std::exp(-56 / (4 * 4 / 0.710723)),
              1e-6);
}

TEST(TailBounds, NothingIsKnownFromOneValueOrBehindTheLimit) {
  const std::vector<double> one = {1}, beyond = {1, 2, 3, 11};
  EXPECT_EQ(tail_bound(one, 10, 0.95), 1);
  EXPECT_EQ(tail_bound(beyond, 10, 0.95), 1);
  EXPECT_LT(tail_bound(beyond, 1000, 0.95), 1e-3);
  // Without scatter only the count tells: 1 - 0.05^(1/24).
  const std::vector<double> same(24, 1.0);
  EXPECT_NEAR(tail_bound(same, 10, 0.95), 0.11735, 1e-4);
  const std::vector<double> mostly = {1, 1, 1, 1, 1, 1, 1, 1, 0, 0};  // outer quarter alike
  EXPECT_NEAR(tail_bound(mostly, 10, 0.95), 0.25887, 1e-4);
}

TEST(TailBounds, FarLimitsAndManyValuesAreNoTrouble) {
  EXPECT_LT(normal_tail_bound(standard_values(24), 1e9, 0.95), 1e-20);
  // z = 5 -+ 1.645 sqrt((1 + 5^2 / 2) / n) for large n.
  const double large = gsl_cdf_ugaussian_Q(5 - 1.645 * std::sqrt(13.5 / 20000));
  EXPECT_NEAR(normal_tail_bound(standard_values(20000), 5, 0.95), large, 0.02 * large);
  for (const double z : {-0.5, 0.0, 2.5})
    EXPECT_LE(normal_tail_bound(standard_values(3), z, 0.95), 1);
}

TEST(TailBounds, NormalBoundHoldsAtItsConfidence) {
  // Of 4000 samples of 24 the bound is below the true share, Q(3) = 0.00135, in 5 %.
  int below = 0;
  for (std::uint64_t repeat = 0; repeat < 4000; ++repeat) {
    std::vector<double> values;
    for (std::uint32_t k = 0; k < 24; ++k)
      values.push_back(gsl_cdf_ugaussian_Pinv(
          uniform(7, Purpose::noise, repeat, 0, static_cast<std::uint64_t>(k))));
    below += normal_tail_bound(values, 3, 0.95) < gsl_cdf_ugaussian_Q(3);
  }
  EXPECT_NEAR(below, 200, 45);  // three standard deviations
}

}  // namespace
}  // namespace cagetol
