#include "distributions/designs/scrambled_sobol.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

using Points = std::vector<std::vector<double>>;

/// Whether every elementary interval of volume 2^(t-m) holds exactly 2^t of the 2^m points.
bool is_net(const Points& points, const std::vector<std::size_t>& columns, unsigned t) {
  const unsigned m = static_cast<unsigned>(std::bit_width(points.size())) - 1;
  bool balanced = true;
  std::vector<unsigned> digits(columns.size());
  const std::function<void(std::size_t, unsigned)> check = [&](std::size_t i, unsigned left) {
    if (i + 1 < columns.size()) {
      for (digits[i] = 0; digits[i] <= left; ++digits[i]) check(i + 1, left - digits[i]);
      return;
    }
    digits[i] = left;
    std::map<std::vector<std::uint64_t>, unsigned> counts;
    for (const auto& u : points) {
      std::vector<std::uint64_t> cell;
      for (std::size_t k = 0; k < columns.size(); ++k) {
        cell.push_back(static_cast<std::uint64_t>(std::ldexp(u[columns[k]], digits[k])));
      }
      ++counts[cell];
    }
    balanced = balanced && counts.size() == std::size_t{1} << (m - t);
    for (const auto& [cell, count] : counts) balanced = balanced && count == 1u << t;
  };
  check(0, m - t);
  return balanced;
}

std::uint64_t digits_of(double u) {
  return static_cast<std::uint64_t>(u * 0x1p32);
}

// The quality parameter t of the first columns is the sum of (degree - 1) of their primitive
// polynomials: 0, 0, 0, 1, 2.
TEST(ScrambledSobol, EveryScrambleIsANet) {
  DesignSpec spec = spec_of(DesignKind::sobol, 4 * 256, 300);
  spec.scrambles = 4;
  const Design design(spec);
  const Points all = points_of(design);
  for (std::ptrdiff_t scramble = 0; scramble < 4; ++scramble) {
    const Points points(all.begin() + scramble * 256, all.begin() + (scramble + 1) * 256);
    EXPECT_TRUE(is_net(points, {0, 1}, 0));
    EXPECT_TRUE(is_net(points, {0, 1, 2}, 1));
    EXPECT_TRUE(is_net(points, {0, 1, 2, 3}, 3));
    for (std::size_t i = 0; i < 300; ++i) EXPECT_TRUE(is_net(points, {i}, 0)) << "column " << i;
    EXPECT_FALSE(is_net(points, {0, 1, 2}, 0));
  }
}

TEST(ScrambledSobol, EveryLeadingPowerOfTwoIsANet) {
  DesignSpec spec = spec_of(DesignKind::sobol, 256, 2);
  spec.scrambles = 1;
  Points points = points_of(Design(spec));
  for (const std::size_t size : {128, 64, 32, 2, 1}) {
    points.resize(size);
    EXPECT_TRUE(is_net(points, {0, 1}, 0));
  }
}

// Nested scrambling keeps the number of leading binary digits that two points share.
// scipy.stats.qmc.Sobol(d=300, scramble=False, bits=30): leading zeros of point i (natural order),
// 1 <= i <= 15, in columns 0, 1, 2, 9, 99 and 299.
TEST(ScrambledSobol, KeepsTheDistancesOfJoeAndKuosPoints) {
  DesignSpec spec = spec_of(DesignKind::sobol, 16, 300);
  spec.scrambles = 1;
  const Design design(spec);
  const std::map<std::size_t, std::array<int, 15>> shared = {
      {0, {0, 1, 0, 2, 0, 1, 0, 3, 0, 1, 0, 2, 0, 1, 0}},
      {1, {0, 0, 1, 0, 2, 1, 0, 0, 1, 2, 0, 1, 0, 0, 3}},
      {2, {0, 0, 1, 1, 0, 0, 2, 0, 3, 1, 0, 0, 1, 2, 0}},
      {9, {0, 1, 0, 0, 1, 0, 2, 0, 2, 0, 1, 1, 0, 3, 0}},
      {99, {0, 1, 0, 0, 2, 0, 1, 1, 0, 3, 0, 0, 1, 0, 2}},
      {299, {0, 1, 0, 0, 1, 0, 2, 0, 1, 0, 2, 3, 0, 1, 0}}};
  const std::vector<double> origin = point_of(design, 0);
  for (const auto& [column, expected] : shared) {
    for (std::uint64_t i = 1; i <= 15; ++i) {
      const std::uint64_t difference =
          digits_of(origin[column]) ^ digits_of(point_of(design, i)[column]);
      EXPECT_EQ(32 - std::bit_width(difference), expected[i - 1]) << column << ", point " << i;
    }
  }
}

// A digital shift would flip the second digit of both halves alike in every scramble; here, and
// below, the halves are independent.
TEST(ScrambledSobol, FlipsDependOnTheDigitsBefore) {
  constexpr std::uint64_t scrambles = 4096;
  DesignSpec spec = spec_of(DesignKind::sobol, 2 * scrambles, 1);
  spec.scrambles = scrambles;
  const Design design(spec);
  std::array<int, 32> differing{};
  for (std::uint64_t s = 0; s < scrambles; ++s) {
    // The two points are 0 and 1/2 before scrambling: they share all digits but the first.
    const std::uint64_t first = digits_of(point_of(design, 2 * s)[0]);
    const std::uint64_t second = digits_of(point_of(design, 2 * s + 1)[0]);
    for (unsigned k = 0; k < 32; ++k) differing[k] += ((first ^ second) >> (31 - k)) & 1;
  }
  EXPECT_EQ(differing[0], static_cast<int>(scrambles));
  for (unsigned k = 1; k < 32; ++k) {
    EXPECT_NEAR(differing[k], scrambles / 2.0, 4 * std::sqrt(scrambles / 4.0)) << "digit " << k;
  }
}

// The mean over many scrambles of the estimate by four points is the integral, and each point alone
// is uniform.
TEST(ScrambledSobol, IsUnbiased) {
  constexpr std::uint64_t scrambles = 2000;
  DesignSpec spec = spec_of(DesignKind::sobol, 4 * scrambles, 3);
  spec.scrambles = scrambles;
  const Design design(spec);
  const auto f = [](const std::vector<double>& u) { return std::exp(u[0] + u[1]) * u[2] * u[2]; };
  const double exact = std::pow(std::numbers::e - 1, 2) / 3;
  double sum = 0, squares = 0, first_point = 0;
  for (std::uint64_t s = 0; s < scrambles; ++s) {
    double estimate = 0;
    for (std::uint64_t i = 0; i < 4; ++i) estimate += f(point_of(design, 4 * s + i)) / 4;
    sum += estimate;
    squares += estimate * estimate;
    first_point += point_of(design, 4 * s)[1];
  }
  const double average = sum / scrambles;
  const double error = std::sqrt((squares / scrambles - average * average) / scrambles);
  EXPECT_NEAR(average, exact, 4 * error);
  EXPECT_NEAR(first_point / scrambles, 0.5, 4 / std::sqrt(12.0 * scrambles));
}

// Variance of a scramble's estimate for a smooth function falls like N^-3 against N^-1 of
// independent points.
TEST(ScrambledSobol, BeatsIndependentPointsOnASmoothFunction) {
  const auto spread = [](DesignKind kind, std::uint64_t points) {
    constexpr std::uint64_t replicates = 64;
    DesignSpec spec = spec_of(kind, replicates * points, 4);
    spec.scrambles = replicates;
    const Design design(spec);
    double sum = 0, squares = 0;
    for (std::uint64_t s = 0; s < replicates; ++s) {
      double estimate = 0;
      for (std::uint64_t i = 0; i < points; ++i) {
        const std::vector<double> u = point_of(design, s * points + i);
        estimate += (u[0] + u[1] * u[2] + u[3] * u[3]) / static_cast<double>(points);
      }
      sum += estimate;
      squares += estimate * estimate;
    }
    return std::sqrt(squares / replicates - sum * sum / (replicates * replicates));
  };
  EXPECT_LT(spread(DesignKind::sobol, 256), 0.1 * spread(DesignKind::random, 256));
  EXPECT_LT(spread(DesignKind::sobol, 256), 0.25 * spread(DesignKind::sobol, 64));
}

// Three classes of 64 points, and four, where the natural order would give each class a quarter of
// the first column.
TEST(ScrambledSobol, EveryClassIsANet) {
  for (const std::uint64_t classes : {3, 4}) {
    DesignSpec spec = spec_of(DesignKind::sobol, 2 * classes * 64, 2);
    spec.scrambles = 2;
    spec.classes = classes;
    const Design design(spec);
    for (std::uint64_t s = 0; s < 2; ++s) {
      for (std::uint64_t k = 0; k < classes; ++k) {
        Points points;
        for (std::uint64_t base = k; base < classes * 64; base += classes) {
          points.push_back(point_of(design, s * classes * 64 + base));
        }
        EXPECT_TRUE(is_net(points, {0, 1}, 0)) << "class " << k << " of " << classes;
      }
    }
    const std::set<std::vector<double>> distinct = [&] {
      const Points all = points_of(design);
      return std::set<std::vector<double>>(all.begin(), all.end());
    }();
    EXPECT_EQ(distinct.size(), design.rows());
  }
}

TEST(ScrambledSobol, ScramblesDifferAndDoNotDependOnTheirNumber) {
  DesignSpec few = spec_of(DesignKind::sobol, 2 * 8, 3),
             many = spec_of(DesignKind::sobol, 4 * 8, 3);
  few.scrambles = 2;
  many.scrambles = 4;
  const Design design(few), larger(many);
  for (std::uint64_t row = 0; row < 16; ++row) {
    EXPECT_EQ(point_of(design, row), point_of(larger, row));
    EXPECT_NE(point_of(larger, row), point_of(larger, row + 16));
  }
}

TEST(ScrambledSobol, MorePointsExtendAScramble) {
  DesignSpec spec = spec_of(DesignKind::sobol, 64, 3);
  spec.scrambles = 1;
  const Design design(spec);
  spec.rows = 1024;
  const Design larger(spec);
  for (std::uint64_t row = 0; row < 64; ++row) {
    EXPECT_EQ(point_of(design, row), point_of(larger, row));
  }
}

}  // namespace
}  // namespace cagetol
