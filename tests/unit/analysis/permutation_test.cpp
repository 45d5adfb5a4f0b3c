#include "analysis/compare/permutation_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace cagetol {
namespace {

/// Every run a cluster of its own, numbered from `first`.
ClusteredValues sample(const std::vector<double>& values, std::int64_t first) {
  std::vector<std::int64_t> cluster(values.size());
  std::iota(cluster.begin(), cluster.end(), first);
  return {cluster, values};
}

std::vector<double> with_ones(std::size_t count, std::size_t ones) {
  std::vector<double> values(count, 0.0);
  std::fill_n(values.begin(), ones, 1.0);
  return values;
}

TEST(PermutationPValue, IsFishersForAPropertyThatRunsHaveOrNot) {
  // Exact two-sided p-values of the hypergeometric law: 2 / C(8,4), and 2 of 480 against 0.
  double sum = 0;
  constexpr int seeds = 40;
  for (int seed = 0; seed < seeds; ++seed)
    sum += permutation_p_value(sample(with_ones(4, 0), 0), sample(with_ones(4, 4), 100), false,
                               static_cast<std::uint64_t>(seed));
  EXPECT_NEAR(sum / seeds, 2.0 / 70, 0.15 * 2.0 / 70);  // each is off by 1 / sqrt(20)
  EXPECT_GT(
      permutation_p_value(sample(with_ones(480, 0), 0), sample(with_ones(480, 2), 1000), false, 1),
      0.3);
}

TEST(PermutationPValue, PairsChangeSides) {
  // Eight changes of one sign: 2 / 2^8.
  double sum = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
    sum += permutation_p_value(sample(with_ones(8, 0), 0), sample(with_ones(8, 8), 0), true, seed);
  EXPECT_NEAR(sum / 40, 2.0 / 256, 0.15 * 2.0 / 256);
  EXPECT_EQ(permutation_p_value(sample({1, 2, 3}, 0), sample({1, 2, 3}, 0), true, 1), 1);
  // A run that the other side has not, and one without value, do not enter.
  EXPECT_EQ(permutation_p_value(sample({1, 2, 3}, 0), sample({1, 2, 3, 900}, 0), true, 1), 1);
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(permutation_p_value(sample({1, none, 3}, 0), sample({1, 900, 3}, 0), true, 1), 1);
}

TEST(PermutationPValue, IsSmallForAChangeAndTheSameForTheSameSeed) {
  std::vector<double> before, after;
  for (int i = 0; i < 30; ++i)
    before.push_back(std::sin(7 * i)), after.push_back(3 + std::sin(5 * i));
  EXPECT_EQ(permutation_p_value(sample(before, 0), sample(after, 100), false, 5), 1.0 / 50000);
  const double once = permutation_p_value(sample(before, 0), sample(before, 100), false, 5);
  EXPECT_EQ(once, permutation_p_value(sample(before, 0), sample(before, 100), false, 5));
  EXPECT_GT(once, 0.5);
}

TEST(PermutationPValue, DealsOutWholeClusters) {
  // Four lots of 25 equal cages on each side are four draws: 2 / C(8,4), however many the cages.
  ClusteredValues before, after;
  for (std::int64_t lot = 0; lot < 4; ++lot)
    for (int cage = 0; cage < 25; ++cage) {
      before.cluster.push_back(lot), before.value.push_back(0);
      after.cluster.push_back(10 + lot), after.value.push_back(1);
    }
  EXPECT_GT(permutation_p_value(before, after, false, 3), 0.01);
}

TEST(PermutationPValue, IsOneForAConstantWhateverItsRounding) {
  for (const bool paired : {false, true})
    for (int runs = 8; runs <= 200; runs += 7) {
      ClusteredValues before, after;
      for (int i = 0; i < runs; ++i) {
        before.cluster.push_back(i);
        before.value.push_back(0.3);
        if (i % 3 == 0) continue;
        after.cluster.push_back(paired ? i : runs + i);
        after.value.push_back(0.3);
      }
      EXPECT_EQ(permutation_p_value(before, after, paired, 1), 1) << runs;
    }
}

}  // namespace
}  // namespace cagetol
