// Hand values, and numbers of SciPy 1.10; the comment above each names the expression that made
// them.
#include "distributions/law.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace cagetol {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::string refusal(const Law& law) {
  try {
    check(law);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

void expect_close(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-11 * std::abs(expected));
}

// norm(2, 3).ppf(1e-12), .ppf(.975), .cdf(5)
TEST(Normal, AgreesWithScipy) {
  const Normal law{2, 3};
  expect_close(quantile(law, 1e-12), -19.103451475903395);
  expect_close(quantile(law, 0.975), 7.879891953620162);
  expect_close(cdf(law, 5), 0.8413447460685429);
  EXPECT_EQ(quantile(law, 0), -infinity);
  EXPECT_EQ(quantile(law, 1), infinity);
}

// truncnorm(-1, 2, loc=1, scale=.5): ppf(1e-12), ppf(.1), ppf(.9), mean(), std(); truncnorm(10,
// inf) in the same order
TEST(TruncatedNormal, AgreesWithScipy) {
  const TruncatedNormal law{1, 0.5, 0.5, 2};
  expect_close(quantile(law, 1e-12), 0.5000000000016915);
  expect_close(quantile(law, 0.1), 0.6476760894526273);
  expect_close(quantile(law, 0.9), 1.6278576820751074);
  expect_close(mean(law), 1.1148185895456646);
  expect_close(standard_deviation(law), 0.3604727934295229);

  const TruncatedNormal far{0, 1, 10, infinity};
  expect_close(quantile(far, 0.1), 10.010428370091844);
  expect_close(quantile(far, 0.9), 10.2255268112022);
  expect_close(mean(far), 10.098093233962564);
  EXPECT_NEAR(standard_deviation(far), 0.0971873336661236, 1e-10);
}

// A narrow slice of a density is uniform to first order.
TEST(TruncatedNormal, NarrowSliceIsUniform) {
  const TruncatedNormal law{0, 1, 3, 3 + 1e-7};
  EXPECT_NEAR(mean(law) - 3, 0.5e-7, 1e-13);
  EXPECT_NEAR(standard_deviation(law), 1e-7 / std::sqrt(12.0), 1e-13);
}

TEST(Uniform, HitsBothEnds) {
  const Uniform law{0.1, 0.7};
  EXPECT_EQ(quantile(law, 0), 0.1);
  EXPECT_EQ(quantile(law, 1), 0.7);
  EXPECT_DOUBLE_EQ(quantile(law, 0.25), 0.25);
  EXPECT_DOUBLE_EQ(pdf(law, 0.4), 1 / 0.6);
  EXPECT_DOUBLE_EQ(mean(law), 0.4);
  EXPECT_DOUBLE_EQ(standard_deviation(law), 0.6 / std::sqrt(12.0));
}

// triang(.25, loc=1, scale=4): ppf(.1), ppf(.9); by hand: mean (1 + 2 + 5) / 3, variance (16 - 4 +
// 1) / 18
TEST(Triangular, AgreesWithScipyAndHand) {
  const Triangular law{1, 2, 5};
  expect_close(quantile(law, 0.1), 1.632455532033676);
  expect_close(quantile(law, 0.9), 3.904554884989668);
  expect_close(cdf(law, 2), 0.25);
  expect_close(pdf(law, 2), 0.5);
  expect_close(pdf(law, 3.5), 0.25);
  expect_close(mean(law), 8.0 / 3);
  expect_close(standard_deviation(law), std::sqrt(13.0 / 18));
}

// lognorm(.5, loc=2, scale=exp(.3)): ppf(.01), cdf(4), pdf(4), mean(), std()
TEST(Lognormal, AgreesWithScipy) {
  const Lognormal law{0.3, 0.5, 2};
  expect_close(quantile(law, 0.01), 2.4218211217070276);
  expect_close(cdf(law, 4), 0.7841524723713563);
  expect_close(pdf(law, 4), 0.2928578490934949);
  expect_close(mean(law), 3.5295904196633785);
  expect_close(standard_deviation(law), 0.8151804536545525);
}

// weibull_min(1.7, loc=.5, scale=2): ppf(.01), ppf(.99), pdf(2), mean(), std()
TEST(Weibull, AgreesWithScipy) {
  const Weibull law{1.7, 2, 0.5};
  expect_close(quantile(law, 0.01), 0.6336109643394392);
  expect_close(quantile(law, 0.99), 5.411051810637852);
  expect_close(pdf(law, 2), 0.37640137947997077);
  expect_close(mean(law), 2.2844890049986484);
  expect_close(standard_deviation(law), 1.0804717992541106);
}

// Bins of probability 1/4, 0, 3/4.
TEST(Histogram, AgreesWithHand) {
  const Histogram law{{0, 1, 2, 4}, {10, 0, 30}};
  EXPECT_DOUBLE_EQ(quantile(law, 0.125), 0.5);
  EXPECT_DOUBLE_EQ(quantile(law, 0.25), 1);
  EXPECT_DOUBLE_EQ(quantile(law, 0.625), 3);
  EXPECT_DOUBLE_EQ(cdf(law, 1.5), 0.25);
  EXPECT_DOUBLE_EQ(pdf(law, 0.5), 0.25);
  EXPECT_DOUBLE_EQ(pdf(law, 1), 0);
  EXPECT_DOUBLE_EQ(pdf(law, 4), 0.375);
  EXPECT_DOUBLE_EQ(mean(law), 0.25 * 0.5 + 0.75 * 3);
  EXPECT_DOUBLE_EQ(standard_deviation(law),
                   std::sqrt(0.25 / 12 + 0.75 * 4 / 12 + 0.25 * 0.75 * 2.5 * 2.5));
}

TEST(Empirical, DrawsMeasuredValuesOnly) {
  const Empirical law = make_empirical({3, 1, 1, 2});
  EXPECT_EQ(quantile(law, 0.5), 1);
  EXPECT_EQ(quantile(law, 0.500001), 2);
  EXPECT_EQ(quantile(law, 0.75), 2);
  EXPECT_EQ(quantile(law, 0.76), 3);
  EXPECT_EQ(cdf(law, 1), 0.5);
  EXPECT_EQ(cdf(law, 2.5), 0.75);
  EXPECT_DOUBLE_EQ(mean(law), 1.75);
  EXPECT_DOUBLE_EQ(standard_deviation(law), std::sqrt(11.0 / 16));
}

// sigma = T / (6 cp); cpk = (upper - mean) / (3 sigma), cpk_lower = (mean - lower) / (3 sigma).
TEST(Capability, IsANormalLawWhoseMeanLeansToEitherLimit) {
  const Normal centred = normal_of(Capability{-0.05, 0.05, 1.25, {}});
  EXPECT_DOUBLE_EQ(centred.mean, 0);
  EXPECT_DOUBLE_EQ(centred.sigma, 0.1 / 7.5);
  const Normal shifted = normal_of(Capability{8.0, 8.1, 2, 1.0});
  expect_close(shifted.sigma, 0.1 / 12);
  expect_close((8.1 - shifted.mean) / (3 * shifted.sigma), 1.0);
  EXPECT_GT(shifted.mean, 8.05);
  const Normal low = normal_of(Capability{8.0, 8.1, 2, {}, 1.0});
  EXPECT_DOUBLE_EQ(low.sigma, shifted.sigma);
  expect_close((low.mean - 8.0) / (3 * low.sigma), 1.0);
  expect_close(normal_of(Capability{8.0, 8.1, 2, {}, {}, -0.01}).mean, 8.04);
}

TEST(LawName, IsTheOneOfStudyFiles) {
  EXPECT_EQ(law_name(Normal{}), "normal");
  EXPECT_EQ(law_name(TruncatedNormal{}), "truncated_normal");
  EXPECT_EQ(law_name(Uniform{}), "uniform");
  EXPECT_EQ(law_name(Triangular{}), "triangular");
  EXPECT_EQ(law_name(Lognormal{}), "lognormal");
  EXPECT_EQ(law_name(Weibull{}), "weibull");
  EXPECT_EQ(law_name(Histogram{}), "histogram");
  EXPECT_EQ(law_name(Empirical{}), "empirical");
  EXPECT_EQ(law_name(Capability{}), "capability");
}

struct Refusal {
  Law law;
  std::string reason;
};

void PrintTo(const Refusal& of, std::ostream* out) {
  *out << law_name(of.law) << ": " << of.reason;
}

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, WithReason) {
  EXPECT_THAT(refusal(GetParam().law), testing::HasSubstr(GetParam().reason));
}

const double nan = std::nan("");

INSTANTIATE_TEST_SUITE_P(
    Laws, Refused,
    testing::Values(
        Refusal{Normal{0, -1}, "sigma = -1 is no standard deviation; give"},
        Refusal{Normal{0, nan}, "sigma = nan"}, Refusal{Normal{infinity, 1}, "mean = inf"},
        Refusal{TruncatedNormal{0, -1, 0, 1}, "sigma = -1"},
        Refusal{TruncatedNormal{0, 1, 2, 1}, "lower = 2 is not below upper = 1"},
        Refusal{TruncatedNormal{0, 1, 50, 60}, "no probability is left between lower = 50"},
        Refusal{TruncatedNormal{5, 0, 0, 1}, "sigma = 0 and mean = 5 lies outside"},
        Refusal{Uniform{1, 1}, "lower = 1 and upper = 1"},
        Refusal{Uniform{0, infinity}, "upper = inf"},
        Refusal{Triangular{0, 2, 1}, "mode = 2 lies outside lower = 0 .. upper = 1"},
        Refusal{Triangular{1, 0, 0}, "ascending order"},
        Refusal{Lognormal{0, -0.1, 0}, "log_sigma = -0.1"},
        Refusal{Lognormal{nan, 1, 0}, "log_mean = nan"},
        Refusal{Lognormal{0, 1, infinity}, "shift = inf"}, Refusal{Weibull{0, 1, 0}, "shape = 0"},
        Refusal{Weibull{1, 0, 0}, "scale = 0"}, Refusal{Weibull{1, 1, nan}, "shift = nan"},
        Refusal{Histogram{{0, 1}, {1, 1}}, "2 edges and 2 weights"},
        Refusal{Histogram{{}, {}}, "do not make bins"},
        Refusal{Histogram{{0, 0, 1}, {1, 1}}, "edges 0 and 0"},
        Refusal{Histogram{{0, 1, 2}, {1, -1}}, "weight -1"},
        Refusal{Histogram{{0, 1}, {0}}, "all weights are zero"},
        Refusal{Empirical{}, "no measured values"},
        Refusal{Empirical{{2, 1}}, "build the law with make_empirical"},
        Refusal{Empirical{{nan}}, "measured value nan"}, Refusal{Capability{0, 1, 0, {}}, "cp = 0"},
        Refusal{Capability{1, 0, 1, {}}, "ascending"},
        Refusal{Capability{0, 1, 1, 1.2}, "cpk = 1.2 exceeds cp = 1"},
        Refusal{Capability{0, 1, 1, 0.0}, "cpk = 0 puts the mean"},
        Refusal{Capability{0, 1, 1, {}, 1.2}, "cpk_lower = 1.2 exceeds cp = 1"},
        Refusal{Capability{0, 1, 1, {}, {}, -0.5}, "offset = -0.5 puts the mean"},
        Refusal{Capability{0, 1, 1, 0.9, 0.9}, "give one of them"}));

}  // namespace
}  // namespace cagetol
