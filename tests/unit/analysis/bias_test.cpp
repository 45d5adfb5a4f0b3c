#include "analysis/compare/bias.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <vector>

namespace cagetol {
namespace {

TEST(Bias, OfPairsByHand) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Bias b = compare_pairs({1, 9, 2, 3, nan}, {2, nan, 4, 6, 7});
  EXPECT_DOUBLE_EQ(b.bias, -2);  // differences -1, -2, -3
  EXPECT_DOUBLE_EQ(b.standard_error, std::sqrt(1.0 / 3));
  EXPECT_DOUBLE_EQ(b.deviation, 2);
  EXPECT_DOUBLE_EQ(b.allowed, 2 / std::sqrt(1000.0));
  // Two degrees of freedom: t at 97.5 % is 4.3027.
  EXPECT_NEAR(b.upper_limit, 2 + 4.3027 * b.standard_error, 1e-4);
  EXPECT_EQ(b.verdict, BiasVerdict::unresolved);
}

TEST(Bias, IsResolvedOnlyByEnoughReplicas) {
  // Means near 0 and near each other, scatter alike; nothing in common but their law.
  std::vector<double> few, many, other, far;
  for (int k = 0; k < 40000; ++k) {
    other.push_back(std::sin(1.0 + 7 * k));
    many.push_back(std::sin(2.0 + 11 * k));
    far.push_back(many.back() + 0.2);
    if (k < 100) few.push_back(many.back());
  }
  EXPECT_EQ(compare_pairs(few, other).verdict, BiasVerdict::unresolved);
  EXPECT_EQ(compare_pairs(many, other).verdict, BiasVerdict::unbiased);
  EXPECT_EQ(compare_pairs(far, other).verdict, BiasVerdict::biased);
  // What pairs share does not hide a difference.
  std::vector<double> near;
  for (const double x : few) near.push_back(x + 0.1 * std::sin(100 * x));
  EXPECT_EQ(compare_pairs(near, few).verdict, BiasVerdict::unbiased);
  EXPECT_EQ(compare_pairs({1}, {1, 2}).verdict, BiasVerdict::unresolved);
  EXPECT_EQ(compare_pairs({5, 5.1}, {5, 5}).verdict, BiasVerdict::steady);
  EXPECT_NEAR(replicas_to_resolve(), 7683, 1);
}

TEST(Bias, IsHeldAgainstTheStudyThatIsAsked) {
  const std::vector<double> reference{0, 2, 4}, values{1, 4, 7};
  const Bias b = compare_pairs(values, reference, 100);
  EXPECT_EQ(b.pairs, 3u);
  EXPECT_DOUBLE_EQ(b.mean, 2);
  EXPECT_DOUBLE_EQ(b.bias, 2);
  EXPECT_DOUBLE_EQ(b.allowed, 0.2);
  EXPECT_DOUBLE_EQ(compare_pairs(values, reference, 400).allowed, 0.1);
}

}  // namespace
}  // namespace cagetol
