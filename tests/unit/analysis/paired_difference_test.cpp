#include "analysis/statistics/paired_difference.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "distributions/basics/random_stream.hpp"
#include "tests/support/not_a_number.hpp"

namespace cagetol {
namespace {

TEST(PairedDifference, IsTheMeanWithStudentsInterval) {
  // Differences 1, 2, 3: mean 2, s = 1, t(2; 97.5 %) = 4.302653.
  const std::vector<double> first = {10, 20, 30}, second = {11, 22, 33};
  const PairedDifference seen = paired_difference(first, second, 0.95);
  EXPECT_EQ(seen.pairs, 3u);
  EXPECT_DOUBLE_EQ(seen.difference.value, 2);
  EXPECT_NEAR(seen.difference.upper - 2, 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(2 - seen.difference.lower, 4.302653 / std::sqrt(3.0), 1e-6);
}

TEST(PairedDifference, LeavesOutPairsWithoutAValue) {
  const std::vector<double> first = {1, kNan, 3, 4}, second = {2, 5, kNan, 6};
  const PairedDifference seen = paired_difference(first, second, 0.95);
  EXPECT_EQ(seen.pairs, 2u);
  EXPECT_DOUBLE_EQ(seen.difference.value, 1.5);
}

TEST(PairedDifference, SaysWhenNothingDiffersAtAll) {
  const std::vector<double> values = {0.1, 0.2, 0.3};
  const PairedDifference seen = paired_difference(values, values, 0.95);
  EXPECT_EQ(seen.difference.lower, 0);
  EXPECT_EQ(seen.difference.upper, 0);
}

TEST(PairedDifference, WithoutTwoPairsHasNoInterval) {
  EXPECT_EQ(paired_difference({}, {}, 0.95).pairs, 0u);
  const std::vector<double> one = {1}, two = {3};
  const PairedDifference seen = paired_difference(one, two, 0.95);
  EXPECT_EQ(seen.difference.value, 2);
  EXPECT_TRUE(std::isnan(seen.difference.lower));
}

// What the pairing is for: scatter that both sides share cancels; and the interval keeps its
// promise.
TEST(PairedDifference, HoldsTheTruthAsOftenAsItSays) {
  constexpr int kRepeats = 2000;
  int held = 0;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    RandomStream draws(1, Purpose::noise, static_cast<std::uint64_t>(repeat), 0);
    std::vector<double> first, second;
    for (int k = 0; k < 16; ++k) {
      const double shared = 50 * draws.next();
      first.push_back(shared + gsl_cdf_ugaussian_Pinv(draws.next()));
      second.push_back(shared + 0.7 + gsl_cdf_ugaussian_Pinv(draws.next()));
    }
    const Estimate d = paired_difference(first, second, 0.95).difference;
    held += d.lower < 0.7 && 0.7 < d.upper;
    EXPECT_LT(d.upper - d.lower, 5);
  }
  EXPECT_NEAR(held / double(kRepeats), 0.95, 0.015);  // three standard errors
}

}  // namespace
}  // namespace cagetol
