#include "distributions/design.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

TEST(LatinHypercube, HasOnePointInEveryCellOfEveryColumn) {
  for (const std::uint64_t rows : {1, 2, 7, 64, 1000, 12345}) {
    const Design design(spec_of(DesignKind::lhs, rows, 4));
    std::vector<std::set<std::uint64_t>> cells(4);
    for (const auto& u : points_of(design)) {
      for (std::size_t i = 0; i < 4; ++i) {
        cells[i].insert(static_cast<std::uint64_t>(u[i] * static_cast<double>(rows)));
      }
    }
    for (const auto& column : cells) {
      EXPECT_EQ(column.size(), rows);
      EXPECT_EQ(*column.rbegin(), rows - 1);
    }
  }
}

// 24 bits of jitter in the last cell of the largest design: still one cell, still below 1.
TEST(LatinHypercube, KeepsItsCellsInTheLargestDesign) {
  const std::uint64_t rows = std::uint64_t{1} << 28;
  const Design design(spec_of(DesignKind::lhs, rows, 1));
  std::set<std::uint64_t> cells;
  for (std::uint64_t row = 0; row < 1000; ++row) {
    const double u = point_of(design, row)[0];
    EXPECT_GT(u, 0);
    EXPECT_LT(u, 1);
    cells.insert(static_cast<std::uint64_t>(u * static_cast<double>(rows)));
  }
  EXPECT_EQ(cells.size(), 1000u);
}

TEST(LatinHypercube, ColumnsAreUncorrelated) {
  constexpr std::uint64_t rows = 4096;
  const Design design(spec_of(DesignKind::lhs, rows, 3));
  double first = 0, second = 0;
  for (const auto& u : points_of(design)) {
    first += (u[0] - 0.5) * (u[1] - 0.5);
    second += (u[1] - 0.5) * (u[2] - 0.5);
  }
  const double bound = 4 / std::sqrt(static_cast<double>(rows));
  EXPECT_LT(std::abs(12 * first / rows), bound);
  EXPECT_LT(std::abs(12 * second / rows), bound);
}

TEST(LatinHypercube, PlaceWithinTheCellIsUniform) {
  constexpr std::uint64_t rows = 4096;
  const Design design(spec_of(DesignKind::lhs, rows, 1));
  double sum = 0, squares = 0;
  for (const auto& u : points_of(design)) {
    const double cell = u[0] * rows, place = cell - std::floor(cell);
    sum += place;
    squares += place * place;
  }
  EXPECT_NEAR(sum / rows, 0.5, 4 / std::sqrt(12.0 * rows));
  EXPECT_NEAR(squares / rows, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / rows));
}

}  // namespace
}  // namespace cagetol
