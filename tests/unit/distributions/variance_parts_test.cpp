#include "distributions/variance_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "distributions/basics/random_stream.hpp"
#include "distributions/laws/normal.hpp"

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

TEST(VarianceParts, AreThoseOfTheAnalysisOfVariance) {
  // Means 2 and 6; within (1 + 1 + 1 + 1) / 2 = 2, between 2 (4 + 4) / 1 = 16.
  const PartsProcess found = variance_parts({{1, 3}, {5, kNone, 7}}).estimate;
  EXPECT_DOUBLE_EQ(found.mean, 4);
  EXPECT_DOUBLE_EQ(found.own_sigma, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(found.group_sigma, std::sqrt((16.0 - 2) / 2));
  EXPECT_DOUBLE_EQ(found.total_sigma(), 3);
}

TEST(VarianceParts, OfUnequalGroupsTakeTheHarmonicMeanOfTheirSizes) {
  // Sizes 1 and 3: n = 2 / (1 + 1/3) = 1.5. Means 0 and 4; within (1 + 1) / 2, between 1.5 (4 + 4).
  const PartsProcess found = variance_parts({{0}, {3, 4, 5}}).estimate;
  EXPECT_DOUBLE_EQ(found.mean, 2);
  EXPECT_DOUBLE_EQ(found.own_sigma, 1);
  EXPECT_DOUBLE_EQ(found.group_sigma, std::sqrt((12.0 - 1) / 1.5));
}

TEST(VarianceParts, OfOneGroupAreItsOwnScatter) {
  const VarianceParts parts = variance_parts({{1, 2, 3, 4, 5}});
  EXPECT_EQ(parts.estimate.group_sigma, 0);
  EXPECT_DOUBLE_EQ(parts.estimate.own_sigma, std::sqrt(2.5));
  // Chi-square and Student t, four degrees of freedom: 11.143 and 0.4844, 2.776.
  const Interval sigma = interval_of(
      parts.allowed, [](const auto& of) { return of.own_sigma; }, 0.95);
  EXPECT_NEAR(sigma.lower, std::sqrt(10 / 11.143), 0.01);
  EXPECT_NEAR(sigma.upper, std::sqrt(10 / 0.4844), 0.15);
  const Interval mean = interval_of(
      parts.allowed, [](const auto& of) { return of.mean; }, 0.95);
  EXPECT_NEAR(mean.upper, 3 + 2.776 * std::sqrt(2.5 / 5), 0.06);
  EXPECT_NEAR(mean.lower, 3 - 2.776 * std::sqrt(2.5 / 5), 0.06);
}

TEST(VarianceParts, WithoutScatterBetweenGroupsAreNotNegative) {
  EXPECT_EQ(variance_parts({{-1, 1}, {1, -1}, {-2, 2}}).estimate.group_sigma, 0);
}

TEST(VarianceParts, NeedTwoValuesAndOneInEachGroup) {
  EXPECT_THROW(variance_parts({{1}}), std::invalid_argument);
  EXPECT_THROW(variance_parts({{1, 2}, {kNone}}), std::invalid_argument);
}

/// Share of 300 processes whose interval holds what they are.
double covered(std::size_t groups, std::size_t size, const PartsProcess& truth,
               const std::function<double(const PartsProcess&)>& value) {
  constexpr int kProcesses = 300;
  int held = 0;
  for (int p = 0; p < kProcesses; ++p) {
    RandomStream stream(68, Purpose::noise, static_cast<std::uint64_t>(p));
    std::vector<std::vector<double>> parts(groups);
    for (auto& group : parts) {
      const double shared = quantile(Normal{truth.mean, truth.group_sigma}, stream.next());
      for (std::size_t j = 0; j < size; ++j)
        group.push_back(shared + quantile(Normal{0, truth.own_sigma}, stream.next()));
    }
    const Interval ends = interval_of(variance_parts(parts).allowed, value, 0.95);
    held += ends.lower <= value(truth) && value(truth) <= ends.upper;
  }
  return held / double{kProcesses};
}

TEST(VarianceParts, IntervalsOfACapabilityHoldTheTruth) {
  // Ppk of a tolerance of 0.1 about 0.
  const auto ppk = [](const PartsProcess& of) {
    return (0.05 - std::abs(of.mean)) / 3 / of.total_sigma();
  };
  EXPECT_GE(covered(5, 12, {0.003, 0.010, 0.006}, ppk), 0.9);
  EXPECT_GE(covered(12, 13, {0.003, 0.002, 0.008}, ppk), 0.9);
}

}  // namespace
}  // namespace cagetol
