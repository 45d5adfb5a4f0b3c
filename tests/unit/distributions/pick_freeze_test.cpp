#include "distributions/designs/pick_freeze.hpp"

#include <gtest/gtest.h>

#include <array>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

/// Group 0: columns 0 and 2; group 1: column 1; group 2: noise, without columns.
DesignSpec grouped_spec(std::uint64_t bases) {
  DesignSpec spec = spec_of(DesignKind::pick_freeze, bases * 5, 3);
  spec.columns[2].group = 0;
  spec.groups = 3;
  return spec;
}

TEST(PickFreeze, RowsOfABaseAreAAndBAndAWithOneGroupOfB) {
  const Design design(grouped_spec(8));
  EXPECT_EQ(design.blocks(), 5u);
  for (std::uint64_t base = 0; base < 8; ++base) {
    const auto a = point_of(design, design.row_of(0, base));
    const auto b = point_of(design, design.row_of(1, base));
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NE(a[i], b[i]);
    EXPECT_EQ(point_of(design, design.row_of(2, base)), (std::vector{b[0], a[1], b[2]}));
    EXPECT_EQ(point_of(design, design.row_of(3, base)), (std::vector{a[0], b[1], a[2]}));
    EXPECT_EQ(point_of(design, design.row_of(4, base)), a);
  }
}

TEST(PickFreeze, RowsOfABaseAreNeighbours) {
  const Design design(grouped_spec(8));
  EXPECT_EQ(design.row_of(0, 3), 15u);
  EXPECT_EQ(design.row_of(4, 3), 19u);
  EXPECT_EQ(design.block_of(17), 2u);
  EXPECT_EQ(design.base_of(17), 3u);
}

TEST(PickFreeze, SourceTellsWhoseValuesAGroupHas) {
  const Design design(grouped_spec(2));
  const std::array<std::array<std::uint64_t, 3>, 5> of_base_1 = {
      {{2, 2, 2}, {3, 3, 3}, {3, 2, 2}, {2, 3, 2}, {2, 2, 3}}};
  for (std::uint64_t block = 0; block < 5; ++block) {
    for (std::uint32_t group = 0; group < 3; ++group) {
      EXPECT_EQ(design.source_of(design.row_of(block, 1), group), of_base_1[block][group]);
    }
  }
}

// Jansen: T_g = mean((f(A) - f(A with g of B))^2) / (2 Var f). f = u0 + 2 u1 has T = 1/5 and 4/5.
TEST(PickFreeze, GivesTotalIndicesOfALinearFunction) {
  constexpr std::uint64_t bases = 4000;
  const Design design(spec_of(DesignKind::pick_freeze, bases * 4, 2));
  const auto f = [&](std::uint64_t block, std::uint64_t base) {
    const auto u = point_of(design, design.row_of(block, base));
    return u[0] + 2 * u[1];
  };
  std::array<double, 2> total{};
  for (std::uint64_t base = 0; base < bases; ++base) {
    for (std::size_t g = 0; g < 2; ++g) {
      const double difference = f(0, base) - f(2 + g, base);
      total[g] += difference * difference / (2 * bases * 5.0 / 12);
    }
  }
  EXPECT_NEAR(total[0], 0.2, 0.02);
  EXPECT_NEAR(total[1], 0.8, 0.06);
}

}  // namespace
}  // namespace cagetol
