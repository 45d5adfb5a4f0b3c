#include "distributions/dependence.hpp"

#include <gmock/gmock.h>
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

using Pairs = std::vector<CorrelatedPair>;

std::string refusal(std::size_t dimensions, const Pairs& pairs) {
  try {
    const GaussianCopula copula(dimensions, pairs);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(NormalCorrelation, IsItselfForNormalLaws) {
  EXPECT_EQ(normal_correlation(Normal{1, 2}, Normal{0, 1}, 0.37), 0.37);
  EXPECT_EQ(normal_correlation(Normal{1, 2}, Capability{0, 1, 1, {}}, -0.9), -0.9);
  EXPECT_EQ(normal_correlation(Lognormal{0, 1, 0}, Weibull{2, 1, 0}, 0), 0);
  EXPECT_EQ(normal_correlation(Normal{0, 0}, Weibull{2, 1, 0}, 0.5), 0.5);
}

// Uniform laws: Pearson = 6 / pi asin(r / 2). Lognormal laws of equal s: r = log(1 + rho (exp(s^2)
// - 1)) / s^2.
TEST(NormalCorrelation, AgreesWithClosedForms) {
  for (const double rho : {-0.95, -0.5, 0.1, 0.7, 0.95}) {
    EXPECT_NEAR(normal_correlation(Uniform{0, 1}, Uniform{-3, 5}, rho),
                2 * std::sin(std::numbers::pi * rho / 6), 1e-9);
  }
  for (const double rho : {-0.5, 0.1, 0.5, 0.9}) {
    EXPECT_NEAR(normal_correlation(Lognormal{0, 0.5, 0}, Lognormal{2, 0.5, 1}, rho),
                std::log(1 + rho * std::expm1(0.25)) / 0.25, 1e-9);
  }
}

// scipy 1.10: root in q of the double Gauss-Hermite sum (120 x 120) of
// (a.ppf(Phi(z1)) - a.mean()) (b.ppf(Phi(q z1 + sqrt(1 - q^2) z2)) - b.mean()) / (a.std() b.std())
// = rho, for lognorm(.5), weibull_min(1.7), weibull_min(4)
TEST(NormalCorrelation, AgreesWithTheDoubleIntegral) {
  const Law lognormal = Lognormal{0, 0.5, 0}, skewed = Weibull{1.7, 1, 0}, even = Weibull{4, 1, 0};
  EXPECT_NEAR(normal_correlation(lognormal, skewed, 0.6), 0.6251621533283869, 1e-8);
  EXPECT_NEAR(normal_correlation(lognormal, skewed, -0.4), -0.45348782096285023, 1e-8);
  EXPECT_NEAR(normal_correlation(skewed, even, 0.5), 0.5140575500567374, 1e-8);
}

// Two values, cut at the median: Pearson = 2 / pi asin(r).
TEST(NormalCorrelation, HandlesMeasuredValues) {
  const Law coin = make_empirical({0, 1});
  EXPECT_NEAR(normal_correlation(coin, coin, 0.5), std::sin(std::numbers::pi / 4), 2e-3);
}

TEST(NormalCorrelation, RefusesWhatNoCopulaGives) {
  EXPECT_THROW(normal_correlation(Normal{0, 1}, Normal{0, 1}, 1), std::invalid_argument);
  try {
    normal_correlation(Lognormal{0, 1, 0}, Lognormal{0, 1, 0}, -0.5);
    FAIL();
  } catch (const std::invalid_argument& error) {
    // (exp(-1) - 1) / (e - 1) = -0.368
    EXPECT_THAT(error.what(), testing::HasSubstr("lognormal law of these parameters: the range is "
                                                 "-0.36"));
  }
}

TEST(GaussianCopula, GivesTheCholeskyCombination) {
  const GaussianCopula copula(2, Pairs{{1, 0, 0.6}});
  std::array<double, 2> u = {0.2, 0.7};
  const double z = 0.6 * gsl_cdf_ugaussian_Pinv(0.2) + 0.8 * gsl_cdf_ugaussian_Pinv(0.7);
  copula.correlate(u);
  EXPECT_EQ(u[0], 0.2);
  EXPECT_NEAR(u[1], gsl_cdf_ugaussian_P(z), 1e-15);
}

TEST(GaussianCopula, LeavesIndependentCoordinatesUntouched) {
  const GaussianCopula none(3, Pairs{}), some(4, Pairs{{0, 2, 0.5}});
  std::array<double, 3> u = {0.1, 0.2, 0.3};
  none.correlate(u);
  EXPECT_EQ(u, (std::array<double, 3>{0.1, 0.2, 0.3}));
  std::array<double, 4> v = {0.1, 0.2, 0.3, 0};
  some.correlate(v);
  EXPECT_EQ(v[0], 0.1);
  EXPECT_EQ(v[1], 0.2);
  EXPECT_NE(v[2], 0.3);
  EXPECT_EQ(v[3], 0);
}

// Sampled from start to end: the Pearson correlation asked for, uniform marginals.
TEST(GaussianCopula, DeliversThePearsonCorrelation) {
  const Law first = Lognormal{0, 0.5, 0}, second = Weibull{1.7, 1, 0};
  const GaussianCopula copula(2, Pairs{{0, 1, normal_correlation(first, second, 0.6)}});
  constexpr int n = 40000;
  double products = 0, sum = 0, squares = 0;
  for (std::uint64_t i = 0; i < n; ++i) {
    std::array<double, 2> u = {uniform(1, Purpose::lot, i, 0, 0),
                               uniform(1, Purpose::lot, i, 1, 0)};
    copula.correlate(u);
    products += (quantile(first, u[0]) - mean(first)) * (quantile(second, u[1]) - mean(second));
    sum += u[1];
    squares += u[1] * u[1];
  }
  const double rho = products / n / (standard_deviation(first) * standard_deviation(second));
  EXPECT_NEAR(rho, 0.6, 0.04);
  EXPECT_NEAR(sum / n, 0.5, 4 / std::sqrt(12.0 * n));
  EXPECT_NEAR(squares / n, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / n));
}

TEST(GaussianCopula, StaysInsideTheOpenInterval) {
  const GaussianCopula copula(2, Pairs{{0, 1, 0.9}});
  for (const double end : {0x1p-53, 1 - 0x1p-53}) {
    std::array<double, 2> u = {end, end};
    copula.correlate(u);
    EXPECT_GT(u[1], 0);
    EXPECT_LT(u[1], 1);
  }
  std::array<double, 2> contradiction = {0, 1};
  EXPECT_THROW(copula.correlate(contradiction), std::invalid_argument);
}

TEST(GaussianCopula, RefusesWhatIsNoCorrelationMatrix) {
  using testing::HasSubstr;
  // Equal correlations of three inputs are possible down to -1/2: -0.9 must shrink by 0.5 / 0.9 =
  // 0.5556.
  const std::string message = refusal(3, {{0, 1, -0.9}, {0, 2, -0.9}, {1, 2, -0.9}});
  EXPECT_THAT(message, HasSubstr("contradict each other: the smallest eigenvalue of their matrix "
                                 "is -0.8"));
  EXPECT_THAT(message, HasSubstr("multiplied by less than 0.5555"));
  EXPECT_EQ(refusal(3, {{0, 1, -0.49}, {0, 2, -0.49}, {1, 2, -0.49}}), "accepted");
  EXPECT_THAT(refusal(2, {{0, 1, 1}}), HasSubstr("rho = 1 is not within"));
  EXPECT_THAT(refusal(2, {{0, 2, 0.1}}), HasSubstr("between coordinates 0 and 2 of 2"));
  EXPECT_THAT(refusal(2, {{1, 1, 0.1}}), HasSubstr("name two different inputs"));
  EXPECT_THAT(refusal(2, {{0, 1, 0.1}, {1, 0, 0.1}}), HasSubstr("given twice"));
  std::array<double, 3> u{};
  EXPECT_THROW(GaussianCopula(2, Pairs{}).correlate(u), std::invalid_argument);
}

}  // namespace
}  // namespace cagetol
