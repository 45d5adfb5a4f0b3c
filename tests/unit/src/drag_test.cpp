#include "src/lubrication/drag.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cagetol {
namespace {

TEST(Drag, FluidOfTheFreeSpaceLiesBetweenAirAndOil) {
  const auto air = free_space_fluid(0, 850, 0.02), oil = free_space_fluid(1, 850, 0.02);
  EXPECT_DOUBLE_EQ(air.density, 1.2);
  EXPECT_DOUBLE_EQ(oil.density, 850);
  EXPECT_DOUBLE_EQ(oil.viscosity, 0.02);
  EXPECT_NEAR(free_space_fluid(0.02, 870, 0.02).density, 0.02 * 870 + 0.98 * 1.2, 1e-12);
  EXPECT_THROW(free_space_fluid(1.1, 850, 0.02), std::domain_error);
}

TEST(Drag, CoefficientsOfBothRegimes) {
  EXPECT_DOUBLE_EQ(disc_coefficient(1e4), 1.935 / 100);
  EXPECT_DOUBLE_EQ(disc_coefficient(1e7), 0.073 * std::pow(1e7, -0.2));
  EXPECT_DOUBLE_EQ(gap_coefficient(100.0), 0.02);
  EXPECT_DOUBLE_EQ(gap_coefficient(1e5), 0.0791 * std::pow(1e5, -0.25));
}

// Laminar shear in a gap is Couette's: tau = eta w r/c.
TEST(Drag, LaminarGapIsCouettes) {
  const FreeSpaceFluid oil{850, 0.02};
  const double w = 100, r = 0.0217, l = 2.4e-3, c = 0.2e-3;
  const double couette = oil.viscosity * w * r / c * 2 * std::numbers::pi * r * r * l;
  EXPECT_NEAR(gap_moment(oil, w, r, l, c), couette, 1e-12 * couette);
}

TEST(Drag, MomentsAreSmoothOverTheTransition) {
  const FreeSpaceFluid fluid{850, 0.001};
  const double transition = 3e5 * fluid.viscosity / (fluid.density * 0.05 * 0.05);
  for (double share = 0.3; share < 3; share *= 1.05) {
    const double w = share * transition, step = 1e-5 * w;
    const double left = disc_moment(fluid, w, 0.05, 0) - disc_moment(fluid, w - step, 0.05, 0);
    const double right = disc_moment(fluid, w + step, 0.05, 0) - disc_moment(fluid, w, 0.05, 0);
    EXPECT_NEAR(left / right, 1, 1e-3);
  }
  EXPECT_EQ(disc_moment(fluid, 0.0, 0.05, 0), 0);
  EXPECT_EQ(disc_moment(fluid, -9.0, 0.05, 0), -disc_moment(fluid, 9.0, 0.05, 0));
}

}  // namespace
}  // namespace cagetol
