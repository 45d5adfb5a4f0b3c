#include "src/numerics/fixed_power.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <random>

#include "src/numerics/reciprocal.hpp"

namespace cagetol {
namespace {

constexpr int kTrials = 200000;

class PackMath : public testing::Test {
 protected:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  double magnitude(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  std::mt19937_64 engine_{7};
};

double ulp(double x) {
  return std::nextafter(std::abs(x), 1e308) - std::abs(x);
}

TEST_F(PackMath, Log2WithinItsBound) {
  double worst = 0;
  for (int n = 0; n < kTrials; ++n) {
    const double x = n % 2 ? magnitude(1e-300, 1e300) : magnitude(0.5, 2);
    const long double exact = std::log2(static_cast<long double>(x));
    const double error = static_cast<double>(std::abs(log2(splat(x))[3] - exact));
    worst = std::max(worst, error / ulp(std::max(1.0, std::abs(static_cast<double>(exact)))));
  }
  EXPECT_LT(worst, 2);
  EXPECT_EQ(log2(splat(1))[0], 0);
  EXPECT_EQ(log2(splat(1024))[0], 10);
}

TEST_F(PackMath, Exp2WithinItsBound) {
  double worst = 0;
  for (int n = 0; n < kTrials; ++n) {
    const double y = n % 2 ? between(-999, 999) : between(-1, 1);
    const long double exact = std::exp2(static_cast<long double>(y));
    const double error = static_cast<double>(std::abs(exp2(splat(y))[kLanes - 1] - exact));
    worst = std::max(worst, error / ulp(static_cast<double>(exact)));
  }
  EXPECT_LT(worst, 2);
  EXPECT_EQ(exp2(splat(0))[0], 1);
  EXPECT_EQ(exp2(splat(-10))[0], 1.0 / 1024);
}

TEST_F(PackMath, ReciprocalsWithinTheirBounds) {
  double inverse = 0, root = 0;
  for (int n = 0; n < kTrials; ++n) {
    const double x = n % 2 ? magnitude(1e-300, 1e300) : magnitude(0.5, 2);
    const long double exact = 1 / static_cast<long double>(x);
    const long double exact_root = 1 / std::sqrt(static_cast<long double>(x));
    const auto error = [&](double value, long double due) {
      return static_cast<double>(std::abs(value - due)) / ulp(static_cast<double>(due));
    };
    inverse = std::max(inverse, error(reciprocal(splat(x))[1], exact));
    root = std::max(root, error(inverse_root(splat(x))[2], exact_root));
  }
  EXPECT_LT(inverse, 2);
  EXPECT_LT(root, 3);
}

TEST_F(PackMath, PowerWithinItsBound) {
  double near = 0, far = 0;
  for (int n = 0; n < kTrials; ++n) {
    const double e = n % 3 ? between(0.1, 2.2) : 1.0 / 9;
    const double x = std::exp2(between(-1, 1) * std::min(900.0, (n % 2 ? 8 : 60) / e));
    const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(e));
    const double error = static_cast<double>(std::abs(power(splat(x), e)[1] - exact) / exact);
    (n % 2 ? near : far) = std::max(n % 2 ? near : far, error);
  }
  EXPECT_LT(near, 1e-15);
  EXPECT_LT(far, 6e-15);
}

TEST_F(PackMath, FixedPowerWithinItsBound) {
  double table = 0, beyond = 0, alone = 0;
  for (int n = 0; n < 400; ++n) {
    const double e = n % 3 ? between(0, 2) : 1.0 / 9;
    const FixedPower to_the_e(e);
    for (int k = 0; k < 500; ++k) {
      const double x = std::exp2(k % 2 ? between(-16, 16) : between(-30, 30));
      const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(e));
      const double found = to_the_e(splat(x))[k % kLanes];
      const double error = static_cast<double>(std::abs(found - exact) / exact);
      (k % 2 ? table : beyond) = std::max(k % 2 ? table : beyond, error);
      alone = std::max(alone, static_cast<double>(std::abs(to_the_e(x) - exact) / exact));
    }
    EXPECT_EQ(to_the_e(splat(1))[0], to_the_e(1.0));
  }
  EXPECT_LT(table, 1e-15);
  EXPECT_LT(beyond, 6e-15);
  EXPECT_LT(alone, 6e-15);
}

TEST_F(PackMath, RootAndItsReciprocalWithinTheirBound) {
  double root = 0, reciprocal = 0;
  for (int n = 0; n < kTrials; ++n) {
    const double x = magnitude(1e-30, 1e30);
    Pack inverse;
    const double found = sqrt(splat(x), inverse)[n % kLanes];
    const long double exact = std::sqrt(static_cast<long double>(x));
    root = std::max(root, static_cast<double>(std::abs(found - exact) / exact));
    reciprocal = std::max(reciprocal, static_cast<double>(std::abs(inverse[0] * exact - 1)));
  }
  EXPECT_LT(root, 1.2e-16);
  EXPECT_LT(reciprocal, 5e-16);
}

TEST_F(PackMath, MagnitudesHaveNoSign) {
  for (const double x : {0.0, -0.0, 2.5, -2.5, -1e-310}) {
    const Pack magnitude = abs(splat(x));
    for (int i = 0; i < kLanes; ++i) {
      EXPECT_EQ(magnitude[i], std::abs(x));
      EXPECT_FALSE(std::signbit(magnitude[i])) << x;
    }
  }
}

TEST_F(PackMath, SineAndCosineWithinTheirBound) {
  double worst = 0;
  for (int n = 0; n < kTrials; ++n) {
    const double x = n % 2 ? between(-1e5, 1e5) : between(-10, 10);
    Pack s, c;
    sine_cosine(splat(x), s, c);
    const long double exact_s = std::sin(static_cast<long double>(x)),
                      exact_c = std::cos(static_cast<long double>(x));
    worst = std::max({worst, static_cast<double>(std::abs(s[2] - exact_s)),
                      static_cast<double>(std::abs(c[2] - exact_c))});
  }
  EXPECT_LT(worst, 3e-16) << worst;
  Pack s, c;
  sine_cosine(splat(0), s, c);
  EXPECT_EQ(s[0], 0);
  EXPECT_EQ(c[0], 1);
}

TEST_F(PackMath, ALaneDoesNotMatter) {
  const FixedPower ninth_root(1.0 / 9);
  for (int n = 0; n < 1000; ++n) {
    const double x = n % 3 ? magnitude(1e-6, 1e3) : 1e-7, angle = between(-100, 100);
    Pack mixed = splat(3.7), turned = splat(-2.1);
    for (int lane = 0; lane < kLanes; ++lane) {
      mixed[lane] = x;
      turned[lane] = angle;
      Pack s, c, s0, c0;
      sine_cosine(turned, s, c);
      sine_cosine(splat(angle), s0, c0);
      ASSERT_EQ(power(mixed, 10.0 / 9)[lane], power(splat(x), 10.0 / 9)[0]);
      ASSERT_EQ(ninth_root(mixed)[lane], ninth_root(splat(x))[0]);
      ASSERT_EQ(sqrt(mixed)[lane], std::sqrt(x));
      ASSERT_EQ(s[lane], s0[0]);
      ASSERT_EQ(c[lane], c0[0]);
    }
  }
}

TEST_F(PackMath, TransposeMakesRowsColumns) {
  Eight rows[kLanes];
  for (int i = 0; i < kLanes; ++i)
    for (int j = 0; j < kEight; ++j) rows[i][j] = 10 * i + j;
  Pack columns[kEight];
  transpose(rows, columns);
  for (int i = 0; i < kEight; ++i)
    for (int j = 0; j < kLanes; ++j) EXPECT_EQ(columns[i][j], 10 * j + i);
}

TEST_F(PackMath, ReadsAndWritesTheFirstLanesAlone) {
  double from[kLanes];
  for (int i = 0; i < kLanes; ++i) from[i] = i + 1;
  for (int n = 0; n <= kLanes + 2; ++n) {
    double to[kLanes];
    std::fill(to, to + kLanes, -5.0);
    store_first(to, load(from), n);
    for (int i = 0; i < kLanes; ++i) {
      EXPECT_EQ(load_first(from, n)[i], i < n ? i + 1 : 0) << n;
      EXPECT_EQ(to[i], i < n ? i + 1 : -5) << n;
    }
  }
}

TEST_F(PackMath, CellIsTheWholePartAndGatherItsEntry) {
  double table[1000];
  for (int i = 0; i < 1000; ++i) table[i] = 3 * i;
  for (int n = 0; n < 1000; ++n) {
    const double x = n % 2 ? between(0, 999) : n + 0.0;
    Pack many = splat(1.5), share;
    many[n % kLanes] = x;
    const Mask at = cell(many, share);
    EXPECT_EQ(at[n % kLanes], static_cast<std::int64_t>(x));
    EXPECT_EQ(share[n % kLanes], x - std::floor(x));
    EXPECT_EQ(real(at)[n % kLanes], std::floor(x));
    EXPECT_EQ(gather(table, at)[n % kLanes], 3 * std::floor(x));
  }
}

TEST_F(PackMath, SelectMinMaxAnySum) {
  Pack x;  // 1, -2, 3, -4, ...
  for (int lane = 0; lane < kLanes; ++lane) x[lane] = lane % 2 ? -lane - 1 : lane + 1;
  constexpr int half = kLanes / 2;
  EXPECT_EQ(sum(x), -half);
  EXPECT_EQ(largest(x), kLanes - 1);
  EXPECT_EQ(smallest(x), -kLanes);
  EXPECT_TRUE(any(x > kLanes - 2.0));
  EXPECT_FALSE(any(x > kLanes - 1.0));
  EXPECT_EQ(sum(max(x, Pack{})), half * half);
  EXPECT_EQ(sum(select(x < 0.0, x, Pack{})), -half * (half + 1));
  Pack lone{};
  for (int lane = 0; lane < kLanes; ++lane) {
    lone = Pack{};
    lone[lane] = 1;
    EXPECT_TRUE(any(lone > 0.0));
  }
}

}  // namespace
}  // namespace cagetol
