#include "distributions/basics/permutation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace cagetol {
namespace {

TEST(Permutation, IsABijection) {
  for (std::uint64_t size : {1, 2, 3, 4, 5, 7, 16, 17, 100, 1000, 4097}) {
    const Permutation permutation(size, {3, static_cast<std::uint32_t>(size)});
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < size; ++i) seen.insert(permutation(i));
    EXPECT_EQ(seen.size(), size);
    EXPECT_EQ(*seen.rbegin(), size - 1);
  }
}

TEST(Permutation, StaysInRangeForLargeSizes) {
  const std::uint64_t size = (std::uint64_t{1} << 40) + 12345;
  const Permutation permutation(size, {1, 2});
  std::set<std::uint64_t> seen;
  for (std::uint64_t i = 0; i < 1000; ++i) seen.insert(permutation(i));
  EXPECT_EQ(seen.size(), 1000u);
  EXPECT_LT(*seen.rbegin(), size);
  EXPECT_GT(*seen.rbegin(), size / 100 * 97);
}

// Over many keys all n! orders are equally frequent. Limits: chi2(n! - 1).ppf(.9999).
TEST(Permutation, OrdersOfFewElementsAreEquallyFrequent) {
  const std::map<std::uint64_t, double> limits = {
      {2, 15.1}, {3, 25.7}, {4, 57.1}, {5, 185.1}, {6, 868.7}};
  for (const auto& [size, limit] : limits) {
    std::map<std::vector<std::uint64_t>, int> counts;
    constexpr int keys = 24000;
    for (std::uint32_t key = 0; key < keys; ++key) {
      const Permutation permutation(size, {key, 99});
      std::vector<std::uint64_t> order;
      for (std::uint64_t i = 0; i < size; ++i) order.push_back(permutation(i));
      ++counts[order];
    }
    const double expected = keys / std::tgamma(static_cast<double>(size) + 1);
    double chi_squared = 0;
    for (const auto& [order, count] : counts) {
      chi_squared += (count - expected) * (count - expected) / expected;
    }
    EXPECT_EQ(static_cast<double>(counts.size()), std::tgamma(static_cast<double>(size) + 1));
    EXPECT_LT(chi_squared, limit) << "size " << size;
  }
}

}  // namespace
}  // namespace cagetol
