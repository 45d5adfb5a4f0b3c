// Which table serves which cage.
#include "src/cage/mesh/cage_grid.hpp"

#include <gtest/gtest.h>

#include "src/cage/mesh/sector_polynomial.hpp"

namespace cagetol {
namespace {

using Deviations = std::vector<PocketDeviation>;

const CageDimensions kCage;

/// What cages at a grid point deviate by.
PocketDeviation deviation_at(const GridPoint& point) {
  const CageDimensions cage = cage_at(kCage, point);
  return {.width = cage.pocket_width - kCage.pocket_width,
          .length = cage.pocket_length - kCage.pocket_length};
}

GridPoint point_of(const PocketDeviation& all) {
  return nearest_point(kCage, Deviations(13, all));
}

TEST(CageGrid, TheScenesOwnCageIsAPointToTheBit) {
  EXPECT_EQ(nearest_point(kCage, Deviations(13)), GridPoint{});
  EXPECT_EQ(cage_at(kCage, {}).pocket_width, kCage.pocket_width);
  EXPECT_EQ(cage_at(kCage, {}).pocket_length, kCage.pocket_length);
}

TEST(CageGrid, PointsAreAQuarterOfTheWidthAndASixthOfTheLengthThatATableCovers) {
  const PocketDeviation range = table_range(kCage), step = deviation_at({1, 1});
  EXPECT_NEAR(4 * step.width, range.width, 1e-12);
  EXPECT_NEAR(6 * step.length, range.length, 1e-12);
}

TEST(CageGrid, TheNearestPointServes) {
  const PocketDeviation step = deviation_at({1, 1});
  EXPECT_EQ(point_of({.width = 0.49 * step.width, .length = -0.49 * step.length}), GridPoint{});
  EXPECT_EQ(point_of({.width = 0.51 * step.width, .length = -0.51 * step.length}),
            (GridPoint{1, -1}));
  EXPECT_EQ(point_of({.width = -2.4 * step.width, .length = 3.6 * step.length}),
            (GridPoint{-2, 4}));
}

TEST(CageGrid, ScatterThatLeavesTheMeanAloneDoesNotChoose) {
  Deviations deviations(13);
  const PocketDeviation step = deviation_at({1, 1});
  for (std::size_t j = 0; j < 6; ++j) {
    deviations[2 * j] = {.width = 2 * step.width, .length = step.length, .pitch = 1e-3};
    deviations[2 * j + 1] = {.width = -2 * step.width, .length = -step.length};
  }
  EXPECT_EQ(nearest_point(kCage, deviations), GridPoint{});
}

TEST(CageGrid, EndsAtTheRangeOfTheNominalTable) {
  EXPECT_EQ(point_of({.width = 0.5e-3, .length = -1.5e-3}), (GridPoint{4, -6}));
  EXPECT_NEAR(deviation_at({4, 6}).width, table_range(kCage).width, 1e-12);
  EXPECT_NEAR(deviation_at({4, 6}).length, table_range(kCage).length, 1e-12);
}

TEST(CageGrid, AnImpossibleCageAndAnImpossiblePointAreLeftToTheNominalTable) {
  Deviations deviations(13, {.width = 0.2e-3});
  deviations[7].width = 2e-3;
  EXPECT_EQ(nearest_point(kCage, deviations), GridPoint{});
  deviations[7].width = std::nan("");
  EXPECT_EQ(nearest_point(kCage, deviations), GridPoint{});
  // Bars far wider than pockets: the grid reaches beyond pockets of no width.
  CageDimensions narrow;
  narrow.pocket_width = 0.5e-3;
  EXPECT_LT(cage_at(narrow, {-1, 0}).pocket_width, 0);
  EXPECT_EQ(nearest_point(narrow, Deviations(13, {.width = -0.4e-3})), GridPoint{});
}

}  // namespace
}  // namespace cagetol
