#include "distributions/designs/grid.hpp"

#include <gtest/gtest.h>

#include "distributions/law.hpp"
#include "tests/unit/distributions/design_helpers.hpp"

namespace cagetol {
namespace {

TEST(Grid, RunsThroughAllCombinationsFirstGroupSlowest) {
  DesignSpec spec = spec_of(DesignKind::grid, 6, 2);
  spec.grid_levels = {2, 3};
  EXPECT_EQ(points_of(Design(spec)),
            (std::vector<std::vector<double>>{{0, 0}, {0, 0.5}, {0, 1}, {1, 0}, {1, 0.5}, {1, 1}}));
}

TEST(Grid, MeetsBothEndsOfAUniformLaw) {
  DesignSpec spec = spec_of(DesignKind::grid, 9, 1);
  spec.grid_levels = {9};
  const Design design(spec);
  const Law law = Uniform{-0.2, 0.3};
  EXPECT_EQ(quantile(law, point_of(design, 0)[0]), -0.2);
  EXPECT_EQ(quantile(law, point_of(design, 8)[0]), 0.3);
  for (std::uint64_t row = 0; row < 9; ++row) {
    EXPECT_NEAR(quantile(law, point_of(design, row)[0]), -0.2 + 0.0625 * row, 1e-15);
  }
}

TEST(Grid, TrimKeepsLevelsAwayFromTheEnds) {
  DesignSpec spec = spec_of(DesignKind::grid, 3, 1);
  spec.grid_levels = {3};
  spec.trim = 0.01;
  EXPECT_EQ(points_of(Design(spec)), (std::vector<std::vector<double>>{{0.01}, {0.5}, {0.99}}));
}

TEST(Grid, OneLevelIsTheMedian) {
  DesignSpec spec = spec_of(DesignKind::grid, 2, 2);
  spec.grid_levels = {1, 2};
  EXPECT_EQ(points_of(Design(spec)), (std::vector<std::vector<double>>{{0.5, 0}, {0.5, 1}}));
}

TEST(Grid, ColumnsOfAGroupShareItsLevel) {
  DesignSpec spec = spec_of(DesignKind::grid, 4, 3);
  spec.columns[1].group = 0;
  spec.columns[2].group = 1;
  spec.grid_levels = {2, 2};
  EXPECT_EQ(points_of(Design(spec)),
            (std::vector<std::vector<double>>{{0, 0, 0}, {0, 0, 1}, {1, 1, 0}, {1, 1, 1}}));
}

}  // namespace
}  // namespace cagetol
