// The lines of a pocket's drawing and its clearances, by closed forms.
#include "src/scene/pocket_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "src/scene/pocket_clearances.hpp"
#include "src/scene/pocket_outline.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kPitchRadius = 19.5e-3, kRollerRadius = 3.75e-3;

/// Smallest distance of a line from the roller's surface.
double gap_to_roller(const DrawnLine& line) {
  double nearest = 1;
  for (std::size_t i = 0; i < line.up.size(); ++i)
    nearest = std::min(nearest, std::hypot(line.across[i], line.up[i] - kPitchRadius));
  return nearest - kRollerRadius;
}

TEST(PocketClearances, FollowTheDimensions) {
  Scene scene = shipped_scene("nu205");
  const PocketClearances c = pocket_clearances(scene, 0);
  EXPECT_NEAR(c.tangential, 0.15e-3, 1e-12);
  EXPECT_NEAR(c.axial, 0.25e-3, 1e-12);
  EXPECT_NEAR(c.ring[1], (43.8e-3 - 43.4e-3) / 2, 1e-12);
  EXPECT_TRUE(std::isinf(c.radial[0]) && std::isinf(c.radial[1]));
  scene.cage.guide_clearance = 0.1e-3;
  EXPECT_DOUBLE_EQ(pocket_clearances(scene, 0).ring[1], 0.1e-3);
  EXPECT_DOUBLE_EQ(pocket_clearances(scene, 0).by_diameters[1], c.ring[1]);
}

TEST(PocketSection, BarsKeepToTheCage) {
  for (const double face_radius : {kAuto, 3.9e-3})
    for (const double lips : {kAuto, 6.9e-3, 7.4e-3}) {
      if (!std::isnan(face_radius) && !std::isnan(lips)) continue;
      Scene scene = shipped_scene("nu205");
      scene.cage.face_radius = face_radius;
      scene.cage.retention_inner = scene.cage.retention_outer = {lips};
      for (const int side : {-1, 1}) {
        const DrawnLine bar = bar_section(scene, 0, side);
        EXPECT_EQ(bar.across.front(), bar.across.back());
        EXPECT_EQ(bar.up.front(), bar.up.back());
        for (std::size_t i = 0; i < bar.up.size(); ++i) {
          const double radius = std::hypot(bar.across[i], bar.up[i]);
          EXPECT_GT(radius, 18.5e-3 - 1e-9);
          EXPECT_LT(radius, 21.7e-3 + 1e-9);
          EXPECT_GT(side * bar.across[i], 0);
          EXPECT_LT(side * std::atan2(bar.across[i], bar.up[i]), M_PI / 13 + 1e-9);
        }
      }
    }
}

TEST(PocketSection, AFlatFaceStandsHalfTheClearanceFromTheRoller) {
  const Scene scene = shipped_scene("nu205");
  DrawnLine face = bar_section(scene, 0, 1);
  double nearest = 1;
  for (const double across : face.across) nearest = std::min(nearest, across);
  EXPECT_NEAR(nearest - kRollerRadius, 0.075e-3, 1e-9);
}

// Moved by its radial play, the roller just touches the lips that are drawn.
TEST(PocketSection, LipsTouchTheRollerThatHasMovedByItsPlay) {
  for (const int end : {0, 1}) {
    Scene scene = shipped_scene("nu205");
    const double width = retention_width(scene.cage, kPitchRadius, kRollerRadius, end, 80e-6);
    (end == 0 ? scene.cage.retention_inner : scene.cage.retention_outer) = {width};
    DrawnLine bar = bar_section(scene, 0, 1);
    EXPECT_GT(gap_to_roller(bar), 20e-6);
    for (double& up : bar.up) up += (end == 0 ? 1 : -1) * 80e-6;
    EXPECT_NEAR(gap_to_roller(bar), 0, 2e-6);  // points lie up to 26 um apart
  }
}

TEST(PocketOpening, HasLeaningSidesAndRoundCorners) {
  Scene scene = shipped_scene("nu205");
  scene.cage.pocket_squareness = {0.01};
  const DrawnLine sharp = pocket_opening(scene, 0, 0);
  ASSERT_EQ(sharp.up.size(), 5U);
  EXPECT_NEAR(sharp.across[0], 7.65e-3 / 2 + 0.01 * 9.25e-3 / 2, 1e-12);
  EXPECT_NEAR(sharp.up[0], 9.25e-3 / 2, 1e-12);
  scene.cage.pocket_squareness = {0};
  const DrawnLine round = pocket_opening(scene, 0, 0.5e-3);
  for (std::size_t i = 0; i < round.up.size(); ++i) {
    const double u = std::abs(round.across[i]) - (7.65e-3 / 2 - 0.5e-3),
                 x = std::abs(round.up[i]) - (9.25e-3 / 2 - 0.5e-3);
    EXPECT_NEAR(std::hypot(u, x), 0.5e-3, 1e-12);
  }
}

}  // namespace
}  // namespace cagetol
