#include "analysis/statistics/capability.hpp"

#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/statistics/value_histogram.hpp"
#include "tests/support/synthetic_study.hpp"

namespace cagetol {
namespace {

/// Quantiles of a law at equal steps of probability: a sample without scatter.
template <class Quantile>
std::vector<double> even_sample(std::size_t count, const Quantile& quantile) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i)
    values.push_back(quantile((static_cast<double>(i) + 0.5) / static_cast<double>(count)));
  return values;
}

TEST(Capability, NormalScatterHasTextbookValues) {
  const StudyData study = plain_study(20000, "grid");
  const auto values =
      even_sample(20000, [](double p) { return 10 + 2 * gsl_cdf_ugaussian_Pinv(p); });
  const auto result = process_capability(values, 2.0, 16.0, Resampling(study, 0), 0.95);
  EXPECT_NEAR(result.cp.value, 14.0 / 12, 2e-3);
  EXPECT_NEAR(result.cpk.value, 1.0, 2e-3);
  EXPECT_NEAR(result.pp.value, 14.0 / 12, 2e-3);  // 99.865 % is three sigma
  EXPECT_NEAR(result.ppk.value, 1.0, 2e-3);
}

TEST(Capability, AConstantHasNone) {
  const StudyData study = plain_study(900);
  std::vector<double> values(900, 0.3);
  for (std::size_t i = 0; i < 900; i += 2) values[i] = std::nextafter(0.3, 1);
  const auto result = process_capability(values, 0.1, 1.0, Resampling(study, 50), 0.95);
  for (const Estimate& estimate : {result.cp, result.cpk, result.pp, result.ppk}) {
    EXPECT_TRUE(std::isnan(estimate.value));
    EXPECT_TRUE(std::isnan(estimate.lower) && std::isnan(estimate.upper));
  }
  EXPECT_EQ(result.percentile_refused, "the quantity does not vary");
}

TEST(Capability, SkewedScatterIsJudgedByItsPercentiles) {
  const StudyData study = plain_study(20000, "grid");
  const auto values = even_sample(20000, [](double p) { return -std::log(1 - p); });
  const auto result = process_capability(values, {}, 8.0, Resampling(study, 0), 0.95);
  const double middle = std::log(2.0), high = -std::log(0.00135);
  EXPECT_NEAR(result.ppk.value, (8 - middle) / (high - middle), 5e-3);
  EXPECT_GT(result.cpk.value, 2);
  EXPECT_TRUE(std::isnan(result.cp.value));
  EXPECT_TRUE(std::isnan(result.pp.value));
}

TEST(Capability, TooFewRunsForTheOuterPercentiles) {
  const StudyData study = plain_study(300);
  const auto values = even_sample(300, [](double p) { return p; });
  const auto result = process_capability(values, 0.0, 1.0, Resampling(study, 50), 0.95);
  EXPECT_FALSE(result.percentile_refused.empty());
  EXPECT_TRUE(std::isnan(result.pp.value));
  EXPECT_GT(result.cp.value, result.cp.lower);
}

TEST(ValueHistogram, CountsEveryValueOnce) {
  const std::vector<double> values = {1, 2, 2.5, 3, NAN, 4, 5, 5};
  const ValueHistogram histogram = value_histogram(values);
  double sum = 0;
  for (const double count : histogram.counts) sum += count;
  EXPECT_EQ(sum, 7);
  EXPECT_EQ(histogram.edges.front(), 1);
  EXPECT_EQ(histogram.edges.back(), 5);
  EXPECT_EQ(histogram.counts.back(), 2);
  EXPECT_EQ(value_histogram(std::vector<double>{3, 3}).counts, std::vector<double>{2});
  EXPECT_TRUE(value_histogram(std::vector<double>{NAN}).counts.empty());
}

}  // namespace
}  // namespace cagetol
