// Ratings, life and minimum loads against the numbers of standards and catalogues.
#include "src/quantities/load_rating.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cagetol {
namespace {

struct TableRow {
  double ratio, factor;
};

class IsoTable7 : public testing::TestWithParam<TableRow> {};

TEST_P(IsoTable7, IsTheFormulaToItsDigits) {
  EXPECT_NEAR(geometry_factor(GetParam().ratio), GetParam().factor, 0.051);
}

INSTANTIATE_TEST_SUITE_P(Rows, IsoTable7,
                         testing::Values(TableRow{0.01, 52.1}, TableRow{0.05, 74.1},
                                         TableRow{0.10, 84.2}, TableRow{0.14, 87.7},
                                         TableRow{0.18, 88.8}, TableRow{0.22, 88.2},
                                         TableRow{0.30, 83.8}));

// SKF General Catalogue, bearings that are not of the uprated class: C within 12 %, C_0 within 16 %
// (rollers as of inputs/scenes/nu205.toml).
TEST(LoadRating, OfNu205IsNearTheCatalogues) {
  const RatedRollers nu205{13, 7.5e-3, 9e-3, 39e-3};
  EXPECT_NEAR(dynamic_rating(nu205), 32.2e3, 50);
  EXPECT_NEAR(static_rating(nu205), 44 * (1 - 7.5 / 39) * 13 * 9 * 7.5, 1e-6);
  EXPECT_NEAR(dynamic_rating(nu205) / 28.6e3, 1, 0.13);
  EXPECT_NEAR(static_rating(nu205) / 27e3, 1, 0.16);
}

TEST(RatingLife, FallsByTheTenThirdsPower) {
  EXPECT_DOUBLE_EQ(rating_life(30e3, 30e3), 1e6);
  EXPECT_NEAR(rating_life(30e3, 3e3), std::pow(10, 10.0 / 3) * 1e6, 1);
  EXPECT_TRUE(std::isinf(rating_life(30e3, 0)));
}

// NU 205 at 6000 rpm: 171 N by SKF with n_ref 14,000 rpm, 450 N by Schaeffler with C_0 27 kN.
TEST(LeastLoad, OfNu205IsThatOfTheMakers) {
  EXPECT_NEAR(minimum_load_skf(0.15, 6000.0 / 14000, 38.5e-3), 171.5, 0.1);
  EXPECT_NEAR(minimum_load_schaeffler(27e3), 450, 1e-9);
}

}  // namespace
}  // namespace cagetol
