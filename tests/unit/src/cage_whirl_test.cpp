// Measures of the cage centre's steadiness on orbits in closed form.
#include "src/quantities/cage_whirl.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kClearance = 0.2e-3, kTurn = 2 * std::numbers::pi;

/// An orbit of the centre, by revolutions of the cage at 100 rad/s, over whole ones.
CageWhirl whirl_of(const std::function<CageWhirl::Seen(double revolutions)>& at, int revolutions) {
  CageWhirl whirl(kClearance);
  const int steps = 400;
  for (int n = 0; n <= steps * revolutions; ++n) {
    const double now = static_cast<double>(n) / steps;
    whirl.record(now * kTurn / 100, at(now));
    if (n > 0 && n % steps == 0) whirl.end_revolution();
  }
  return whirl;
}

double share(const CageWhirl& whirl, OrbitClass of) {
  return whirl.shares()[static_cast<std::size_t>(of)];
}

TEST(CageWhirl, OfACageThatRestsOnItsGuideIsNone) {
  const CageWhirl whirl = whirl_of(
      [](double) { return CageWhirl::Seen{.y = 0.8 * kClearance, .z = -0.6 * kClearance}; }, 3);
  EXPECT_NEAR(whirl.scatter(), 0, 1e-6);
  EXPECT_EQ(share(whirl, OrbitClass::resting), 1);
}

TEST(CageWhirl, OfACircleIsItsRadius) {
  const double radius = 0.9 * kClearance, ratio = 0.5;
  const CageWhirl whirl = whirl_of(
      [&](double turns) {
        const double angle = ratio * turns * kTurn;
        return CageWhirl::Seen{.y = radius * std::cos(angle), .z = radius * std::sin(angle)};
      },
      4);
  EXPECT_NEAR(whirl.scatter(), 0.9, 1e-4);
  EXPECT_EQ(share(whirl, OrbitClass::circling), 1);
}

// On a straight line through the middle it goes round nothing.
TEST(CageWhirl, ToAndFroIsIrregular) {
  const CageWhirl whirl = whirl_of(
      [](double turns) { return CageWhirl::Seen{.y = kClearance * std::sin(3 * kTurn * turns)}; },
      2);
  EXPECT_NEAR(whirl.scatter(), std::sqrt(0.5), 1e-4);
  EXPECT_EQ(share(whirl, OrbitClass::irregular), 1);
}

// Within a revolution it turns by more than circling takes, and comes back.
TEST(CageWhirl, RockingAlongTheGuideIsNotCircling) {
  const CageWhirl whirl = whirl_of(
      [](double turns) {
        const double angle = 59.0 / 360 * kTurn * std::cos(kTurn * turns / 2);
        return CageWhirl::Seen{.y = 0.9 * kClearance * std::cos(angle),
                               .z = 0.9 * kClearance * std::sin(angle)};
      },
      4);
  EXPECT_EQ(share(whirl, OrbitClass::circling), 0);
  EXPECT_EQ(share(whirl, OrbitClass::irregular), 1);
}

TEST(CageWhirl, SharesAreOfWholeRevolutions) {
  EXPECT_TRUE(std::isnan(share(CageWhirl(kClearance), OrbitClass::resting)));
  const CageWhirl whirl = whirl_of(
      [](double turns) {
        const double angle = turns < 1 ? 0 : kTurn * turns;
        return CageWhirl::Seen{.y = 0.9 * kClearance * std::cos(angle),
                               .z = 0.9 * kClearance * std::sin(angle)};
      },
      4);
  EXPECT_EQ(share(whirl, OrbitClass::resting), 0.25);
  EXPECT_EQ(share(whirl, OrbitClass::circling), 0.75);
}

// The centre of the dry cage at 12000 rpm runs along its guide; under oil it rests.
TEST(CageWhirl, OfARunTellsACageThatCirclesFromOneThatRests) {
  Scene scene = shipped_scene("nu205");
  scene.operation.radial_load = 250;
  scene.integration.tolerance = 0.015;
  const Outcome rests = simulate(scene);
  scene = dry_scene("nu205");
  scene.operation.inner_speed *= 2;
  scene.integration.tolerance = 0.015;
  scene.window.settle_revolutions = 10;
  const Outcome circles = simulate(scene);
  ASSERT_EQ(rests.status, Status::ok) << rests.reason;
  ASSERT_EQ(circles.status, Status::ok) << circles.reason;
  EXPECT_GT(quantity(rests, "whirl_radius_ratio_mean"), 0.9);  // as large
  EXPECT_GT(quantity(circles, "whirl_radius_ratio_mean"), 0.9);
  EXPECT_LT(quantity(rests, "whirl_scatter_ratio"), 0.05);
  EXPECT_GT(quantity(circles, "whirl_scatter_ratio"), 0.8);
  EXPECT_EQ(quantity(rests, "whirl_resting_share"), 1);
  EXPECT_GT(quantity(circles, "whirl_circling_share"), 0.8);
  EXPECT_GT(quantity(circles, "whirl_frequency_ratio"), 0.5);  // forward
}

}  // namespace
}  // namespace cagetol
