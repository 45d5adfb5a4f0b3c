// One checker run over every law: what must hold for any of them.
#include "distributions/law.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

namespace cagetol {
namespace {

struct NamedLaw {
  std::string name;
  Law law;
  bool discrete = false;
};

void PrintTo(const NamedLaw& of, std::ostream* out) {
  *out << of.name;
}

const std::vector<NamedLaw> spread_laws = {
    {"normal", Normal{2, 3}},
    {"normal_small", Normal{8.2, 1e-6}},
    {"truncated_normal", TruncatedNormal{1, 0.5, 0.5, 2}},
    {"truncated_normal_one_sided", TruncatedNormal{0, 1, 10}},
    {"truncated_normal_below", TruncatedNormal{0, 1, -8, -6}},
    {"truncated_normal_narrow", TruncatedNormal{0, 1, 0.5, 0.501}},
    {"uniform", Uniform{-1, 3}},
    {"triangular", Triangular{1, 2, 5}},
    {"triangular_left", Triangular{1, 1, 5}},
    {"triangular_right", Triangular{1, 5, 5}},
    {"lognormal", Lognormal{0.3, 0.5, 2}},
    {"weibull", Weibull{1.7, 2, 0.5}},
    {"weibull_steep", Weibull{300, 1, 0}},
    {"histogram", Histogram{{-2, -1, 0.5, 1, 4}, {1, 5, 0, 2}}},
    {"histogram_empty_ends", Histogram{{0, 1, 2, 3}, {0, 7, 0}}},
    {"empirical", make_empirical({0.3, -1, 2, 2, 7, 0.1, 5}), true},
    {"empirical_25", make_empirical([] {
       std::vector<double> values(25);
       for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<double>(i));
       return values;
     }()),
     true},
    {"capability", Capability{-0.05, 0.05, 1.33, {}}},
    {"capability_shifted", Capability{-0.05, 0.05, 1.33, 1.0}},
    {"capability_lower", Capability{-0.05, 0.05, 1.33, {}, 1.0}},
};

std::vector<double> probabilities() {
  std::vector<double> p;
  for (double tail = 1e-12; tail < 0.5e-2; tail *= 3) p.insert(p.end(), {tail, 1 - tail});
  for (int i = 5; i <= 995; ++i) p.push_back(i / 1000.0);
  std::sort(p.begin(), p.end());
  return p;
}

double spacing(double x) {
  return std::nextafter(std::abs(x), std::numeric_limits<double>::infinity()) - std::abs(x);
}

class SpreadLaw : public testing::TestWithParam<NamedLaw> {
 protected:
  const Law& law = GetParam().law;
};

TEST_P(SpreadLaw, IsAccepted) {
  EXPECT_NO_THROW(check(law));
}

// quantile(p) is the smallest x with cdf(x) >= p. Where cdf is continuous that makes them inverses;
// a probability is then as sharp as the digits of x, of the shift and of p allow.
TEST_P(SpreadLaw, QuantileInvertsTheDistribution) {
  std::vector<double> all = probabilities();
  // Where the two empirical laws jump, and just above; 25 (7 / 25) is rounded to more than 7.
  for (const int count : {7, 25}) {
    for (int i = 1; i < count; ++i) {
      const double jump = static_cast<double>(i) / count;
      all.insert(all.end(), {jump, std::nextafter(jump, 1.0)});
    }
  }
  for (const double p : all) {
    const double x = quantile(law, p);
    if (GetParam().discrete) {
      EXPECT_GE(cdf(law, x), p);
      EXPECT_LT(cdf(law, std::nextafter(x, -1e9)), p) << "p = " << p;
    } else {
      const double blur = pdf(law, x) * 8 * spacing(std::abs(x) + std::abs(mean(law)));
      EXPECT_NEAR(cdf(law, x), p, 1e-9 * std::min(p, 1 - p) + 4e-16 + blur) << "p = " << p;
    }
  }
}

TEST_P(SpreadLaw, QuantileNeverDecreases) {
  double last = quantile(law, 0);
  for (const double p : probabilities()) {
    EXPECT_GE(quantile(law, p), last) << "p = " << p;
    last = quantile(law, p);
  }
  EXPECT_GE(quantile(law, 1), last);
}

TEST_P(SpreadLaw, StaysWithinItsSupport) {
  const auto [lower, upper] = support(law);
  EXPECT_LT(lower, upper);
  EXPECT_EQ(quantile(law, 0), lower);
  EXPECT_EQ(quantile(law, 1), upper);
  for (const double p : {0x1p-53, 1e-12, 0.5, 1 - 1e-12, 1 - 0x1p-53}) {
    EXPECT_GE(quantile(law, p), lower);
    EXPECT_LE(quantile(law, p), upper);
    EXPECT_TRUE(std::isfinite(quantile(law, p)));
  }
  EXPECT_EQ(cdf(law, lower - 1), 0);
  EXPECT_EQ(cdf(law, upper + 1), 1);
  EXPECT_EQ(cdf(law, std::numeric_limits<double>::infinity()), 1);
  EXPECT_EQ(cdf(law, -std::numeric_limits<double>::infinity()), 0);
  if (GetParam().discrete) return;
  if (std::isfinite(lower)) {
    EXPECT_EQ(pdf(law, lower - 1), 0);
  }
  if (std::isfinite(upper)) {
    EXPECT_EQ(pdf(law, upper + 1), 0);
  }
}

// Quadrature of the quantile over 0 < p < 1 by the double-exponential rule p = 1 / (1 + exp(-pi
// sinh t)).
TEST_P(SpreadLaw, MomentsAreThoseOfTheQuantile) {
  constexpr double step = 1.0 / 512;
  double total = 0, first = 0, second = 0;
  const double origin = quantile(law, 0.5);
  for (double t = -3; t <= 3; t += step) {
    const double e = std::exp(-std::numbers::pi * std::sinh(t));
    const double p = 1 / (1 + e);
    if (p == 1) continue;
    const double weight = step * std::numbers::pi * std::cosh(t) * e * p * p;
    const double x = quantile(law, p) - origin;
    total += weight;
    first += weight * x;
    second += weight * x * x;
  }
  EXPECT_NEAR(total, 1, 1e-12);
  const double variance = second - first * first;
  // Jumps and corners of a quantile are met to the accuracy of the step.
  const bool smooth = !GetParam().discrete && !std::holds_alternative<Histogram>(law);
  const double accuracy = smooth ? 1e-6 : 5e-3;
  EXPECT_NEAR(origin + first, mean(law), accuracy * standard_deviation(law));
  EXPECT_NEAR(std::sqrt(variance) / standard_deviation(law), 1, accuracy);
}

TEST_P(SpreadLaw, DensityIsTheDerivativeOfTheDistribution) {
  if (GetParam().discrete) {
    EXPECT_THROW(pdf(law, 0.3), std::domain_error);
    return;
  }
  for (int i = 1; i <= 98; ++i) {
    const double x = quantile(law, i / 99.0 + 0.001);
    const double to_the_end = std::min(x - support(law).lower, support(law).upper - x);
    const double h = std::min(1e-4 * standard_deviation(law), 1e-2 * to_the_end);
    const double slope = (cdf(law, x + h) - cdf(law, x - h)) / (2 * h);
    EXPECT_NEAR(slope / pdf(law, x), 1, 1e-3) << "x = " << x;
  }
}

TEST_P(SpreadLaw, RefusesWhatIsNoProbability) {
  EXPECT_THROW(quantile(law, -1e-9), std::domain_error);
  EXPECT_THROW(quantile(law, 1 + 1e-9), std::domain_error);
  EXPECT_THROW(quantile(law, std::nan("")), std::domain_error);
}

INSTANTIATE_TEST_SUITE_P(Laws, SpreadLaw, testing::ValuesIn(spread_laws),
                         [](const auto& of) { return of.param.name; });

class PlainNumber : public testing::TestWithParam<NamedLaw> {};

TEST_P(PlainNumber, IsALawOfZeroWidth) {
  const Law& law = GetParam().law;
  EXPECT_NO_THROW(check(law));
  const double value = quantile(law, 0.5);
  for (const double p : {0.0, 1e-12, 0.3, 1 - 1e-12, 1.0}) EXPECT_EQ(quantile(law, p), value);
  EXPECT_EQ(mean(law), value);
  EXPECT_EQ(standard_deviation(law), 0);
  EXPECT_EQ(support(law).lower, value);
  EXPECT_EQ(support(law).upper, value);
  EXPECT_EQ(cdf(law, value), 1);
  EXPECT_EQ(cdf(law, std::nextafter(value, -1e9)), 0);
  EXPECT_THROW(pdf(law, value), std::domain_error);
}

INSTANTIATE_TEST_SUITE_P(Laws, PlainNumber,
                         testing::Values(NamedLaw{"normal", Normal{0.3, 0}},
                                         NamedLaw{"truncated_normal",
                                                  TruncatedNormal{0.3, 0, 0, 1}},
                                         NamedLaw{"lognormal", Lognormal{0.3, 0, -2}},
                                         NamedLaw{"empirical", make_empirical({0.3})}),
                         [](const auto& of) { return of.param.name; });

// A new alternative of Law must be added to the list above.
TEST(EveryLaw, IsChecked) {
  for (std::size_t index = 0; index < std::variant_size_v<Law>; ++index) {
    EXPECT_TRUE(std::any_of(spread_laws.begin(), spread_laws.end(),
                            [&](const NamedLaw& of) { return of.law.index() == index; }))
        << "law number " << index;
  }
}

}  // namespace
}  // namespace cagetol
