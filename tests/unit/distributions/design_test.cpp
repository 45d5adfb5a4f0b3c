// What holds for every design, and what is refused.
#include "distributions/design.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

DesignSpec small_spec(DesignKind kind, std::uint32_t columns) {
  DesignSpec spec = spec_of(kind, 32, columns);
  spec.scrambles = 2;
  spec.rows = complete_rows(spec);
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

INSTANTIATE_TEST_SUITE_P(Kinds, EveryDesign,
                         testing::Values(DesignKind::random, DesignKind::lhs, DesignKind::sobol),
                         [](const auto& of) { return std::string(design_name(of.param)); });

TEST(CompleteRows, RoundUpToTheNextWholeDesign) {
  DesignSpec spec = spec_of(DesignKind::random, 1000, 3);
  EXPECT_EQ(complete_rows(spec), 1000u);
  spec.kind = DesignKind::lhs;
  EXPECT_EQ(complete_rows(spec), 1000u);
  spec.kind = DesignKind::sobol;
  EXPECT_EQ(complete_rows(spec), 1024u);  // 8 * 2^7
  spec.classes = 3;
  EXPECT_EQ(complete_rows(spec), 1536u);  // 8 * 3 * 2^6
}

TEST(CompleteRows, RefuseWhatTheyCannotCount) {
  using testing::HasSubstr;
  const auto problem = [](DesignSpec spec) -> std::string {
    try {
      return std::to_string(complete_rows(spec)) + " rows";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  constexpr std::uint64_t huge = ~std::uint64_t{0};
  for (const auto& [kind, name] : spellings(DesignKind{})) {
    EXPECT_THAT(problem(spec_of(kind, huge, 2)), HasSubstr("more than 2^40; ")) << name;
    EXPECT_THAT(problem(spec_of(kind, (1ull << 40) + 1, 2)), HasSubstr("more than 2^40")) << name;
  }
  EXPECT_EQ(problem(spec_of(DesignKind::random, 1ull << 40, 2)), "1099511627776 rows");
  EXPECT_THAT(problem(spec_of(DesignKind::lhs, 1000000000, 2)),
              HasSubstr("a latin hypercube of 1000000000 rows has too many: at most 2^28"));
  EXPECT_EQ(problem(spec_of(DesignKind::lhs, 1u << 28, 2)), "268435456 rows");

  DesignSpec sobol = spec_of(DesignKind::sobol, 1, 2);
  sobol.scrambles = huge / 2;
  sobol.classes = 3;
  EXPECT_THAT(problem(sobol), HasSubstr("more than 2^40"));
  sobol = spec_of(DesignKind::sobol, (1ull << 36) + 1, 2);  // 2^33 in each of 8 scrambles
  EXPECT_THAT(problem(sobol), HasSubstr("longer than the sequence, 2^32 points"));
}

TEST(DesignRefusal, NamesTheReasonAndTheRemedy) {
  using testing::HasSubstr;
  EXPECT_THAT(refusal(spec_of(DesignKind::random, 0, 2)), HasSubstr("at least one row"));
  EXPECT_THAT(refusal(spec_of(DesignKind::sobol, 1000, 2)),
              HasSubstr("1000 rows is not complete: rows are 8 scrambles of a power of two; use "
                        "1024"));
  EXPECT_THAT(refusal(spec_of(DesignKind::lhs, (1u << 28) + 1, 2)), HasSubstr("at most 2^28"));

  DesignSpec spec = spec_of(DesignKind::lhs, 16, 2);
  spec.cages_per_lot = 4;
  EXPECT_THAT(refusal(spec), HasSubstr("cages_per_lot = 4 needs design random"));
  spec.cages_per_lot = 0;
  EXPECT_THAT(refusal(spec), HasSubstr("at least one cage"));

  spec = spec_of(DesignKind::random, 16, 2);
  spec.columns[1] = spec.columns[0];
  EXPECT_THAT(refusal(spec), HasSubstr("two columns have one address"));

  EXPECT_THAT(refusal(spec_of(DesignKind::sobol, 8, 3668)), HasSubstr("at most 3667 columns"));
}

}  // namespace
}  // namespace cagetol
