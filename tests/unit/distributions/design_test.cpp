// What holds for every design, and what is refused.
#include "distributions/design.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

DesignSpec small_spec(DesignKind kind, std::uint32_t columns) {
  DesignSpec spec = spec_of(kind, 32, columns);
  return spec;
}

std::string refusal(const DesignSpec& spec) {
  try {
    const Design design(spec);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

class EveryDesign : public testing::TestWithParam<DesignKind> {};

TEST_P(EveryDesign, HasTheSameBitsInAnyOrder) {
  const Design design(small_spec(GetParam(), 5)), other(small_spec(GetParam(), 5));
  const auto forward = points_of(design);
  for (std::uint64_t row = design.rows(); row-- > 0;) {
    EXPECT_EQ(point_of(other, row), forward[row]);
  }
}

TEST_P(EveryDesign, TakesHundredsOfColumns) {
  const Design design(small_spec(GetParam(), 350));
  EXPECT_EQ(design.dimensions(), 350u);
  for (const std::uint64_t row : {std::uint64_t{0}, design.rows() / 2, design.rows() - 1}) {
    for (const double u : point_of(design, row)) {
      EXPECT_GE(u, 0);
      EXPECT_LE(u, 1);
    }
  }
}

TEST_P(EveryDesign, MayHaveNoColumns) {
  const Design design(small_spec(GetParam(), 0));
  EXPECT_TRUE(point_of(design, 0).empty());
}

TEST_P(EveryDesign, DependsOnItsSeed) {
  DesignSpec spec = small_spec(GetParam(), 5);
  const auto points = points_of(Design(spec));
  spec.seed += std::uint64_t{1} << 40;
  EXPECT_NE(points_of(Design(spec)), points);
}

// Appending an input leaves what the earlier inputs were given.
TEST_P(EveryDesign, KeepsItsColumnsWhenOneIsAppended) {
  const Design small(small_spec(GetParam(), 5)), large(small_spec(GetParam(), 6));
  for (std::uint64_t row = 0; row < small.rows(); ++row) {
    std::vector<double> u = point_of(large, row);
    u.pop_back();
    EXPECT_EQ(u, point_of(small, row));
  }
}

TEST_P(EveryDesign, RefusesRowsBeyondItsEndAndWrongSizes) {
  const Design design(small_spec(GetParam(), 5));
  std::vector<double> u(5), wrong(4);
  EXPECT_THROW(design.point(design.rows(), u), std::invalid_argument);
  EXPECT_THROW(design.point(0, wrong), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryDesign, testing::Values(DesignKind::random, DesignKind::lhs),
                         [](const auto& of) { return std::string(design_name(of.param)); });

TEST(DesignRefusal, NamesTheReasonAndTheRemedy) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal(spec_of(DesignKind::random, 0, 2)), HasSubstr("at least one row"));
  constexpr std::uint64_t huge = ~std::uint64_t{0};
  for (const auto& [kind, name] : spellings(DesignKind{})) {
    EXPECT_THAT(refusal(spec_of(kind, huge, 2)), HasSubstr("more than 2^40; ")) << name;
    EXPECT_THAT(refusal(spec_of(kind, (1ull << 40) + 1, 2)), HasSubstr("more than 2^40")) << name;
  }
  EXPECT_EQ(refusal(spec_of(DesignKind::random, 1ull << 40, 2)), "accepted");
  EXPECT_THAT(refusal(spec_of(DesignKind::lhs, 1000000000, 2)),
              HasSubstr("a latin hypercube of 1000000000 rows has too many: at most 2^28"));
  EXPECT_EQ(refusal(spec_of(DesignKind::lhs, 1u << 28, 2)), "accepted");
  EXPECT_THAT(refusal(spec_of(DesignKind::lhs, (1u << 28) + 1, 2)), HasSubstr("at most 2^28"));

  DesignSpec spec = spec_of(DesignKind::lhs, 16, 2);
  spec.cages_per_lot = 4;
  EXPECT_THAT(refusal(spec), HasSubstr("cages_per_lot = 4 needs design random"));
  spec.cages_per_lot = 0;
  EXPECT_THAT(refusal(spec), HasSubstr("at least one cage"));

  spec = spec_of(DesignKind::random, 16, 2);
  spec.columns[1] = spec.columns[0];
  EXPECT_THAT(refusal(spec), HasSubstr("two columns have one address"));
}

}  // namespace
}  // namespace cagetol
