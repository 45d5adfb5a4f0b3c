// Whirl from paths of the cage's centre in closed form.
#include "src/quantities/centre_path.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <functional>
#include <numbers>

namespace cagetol {
namespace {

using Complex = std::complex<double>;
using namespace std::complex_literals;

constexpr double kTurn = 2 * std::numbers::pi, kSpeed = 250;  // of the cage [rad/s]

/// Motion on a path by the turns of the cage, over `turns` of them, in steps of unequal length.
CentreMotion motion_of(const std::function<Complex(double)>& centre, double turns,
                       double load_over_cage = 0, double way = 1) {
  CentrePath path(kTurn / kSpeed / 256);
  const int steps = static_cast<int>(900 * turns);
  for (int n = 0; n <= steps; ++n) {
    const double at = turns * (n + 0.3 * std::sin(n)) / steps;
    path.record(at * kTurn / kSpeed, {centre(at), way * kTurn * at});
  }
  return path.motion(way * load_over_cage * kSpeed);
}

/// A circle that turns at `speed` times the cage's.
Complex circle(double speed, double turns) {
  return std::exp(1i * speed * kTurn * turns);
}

TEST(CentrePath, ARestACircleWithTheCageAndALoadsCircleAreNoWhirl) {
  const CentreMotion motion = motion_of(
      [](double at) { return 70e-6 - 20e-6i + 30e-6 * circle(1, at) + 90e-6 * circle(2.48, at); },
      40, 2.48);
  EXPECT_LT(motion.whirl, 0.1e-6);
  EXPECT_NEAR(motion.circling, 30e-6, 0.1e-6);
  EXPECT_LT(motion.load_line, 0.1e-6);
}

TEST(CentrePath, WhirlIsItsRadiusEitherWayAndSoIsASum) {
  for (const double speed : {2.5, -3.1, 7.3})
    for (const double way : {1.0, -1.0}) {
      const CentreMotion motion = motion_of(
          [&](double at) { return 150e-6 + 60e-6 * circle(way * speed, at); }, 20, 0, way);
      EXPECT_NEAR(motion.whirl, 60e-6, 0.3e-6) << speed;
      EXPECT_NEAR(motion.strongest, speed, 0.05) << speed;
    }
  const CentreMotion both =
      motion_of([](double at) { return 30e-6 * circle(2.2, at) + 40e-6 * circle(-3, at); }, 20);
  EXPECT_NEAR(both.whirl, 50e-6, 0.3e-6);
  EXPECT_NEAR(both.strongest, -3, 0.05);
}

// What is slower than 1.5 of the cage's speed is none, at a broken number of turns either; near the
// cage's speed it is circling.
TEST(CentrePath, SlowerMotionIsNoWhirl) {
  const CentreMotion motion =
      motion_of([](double at) { return 80e-6 * circle(0.43, at) + 25e-6 * circle(1.1, at); }, 20);
  EXPECT_LT(motion.whirl, 1e-6);
  EXPECT_NEAR(motion.circling, 25e-6, 1e-6);
}

// Forty turns part whirl from a load's line where a tenth of the cage's speed lies between them.
TEST(CentrePath, WhirlBesideALoadIsToldFromItOrSaidNotToBe) {
  const auto beside = [](double speed) {
    return motion_of(
        [&](double at) { return 90e-6 * circle(2.48, at) + 60e-6 * circle(speed, at); }, 40, 2.48);
  };
  const CentreMotion apart = beside(2.6), together = beside(2.49);
  EXPECT_NEAR(apart.whirl, 60e-6, 1e-6);
  EXPECT_LT(apart.load_line, 6e-6);
  EXPECT_GT(together.load_line, 0.9 * together.whirl);
}

TEST(WhirlClass, FollowsTheShares) {
  EXPECT_STREQ(whirl_class(NAN, 0, 0), "unknown");
  EXPECT_STREQ(whirl_class(0.4, 0.1, 0.4), "stable");
  EXPECT_STREQ(whirl_class(0.4, 0.1, 0.6), "circling");
  EXPECT_STREQ(whirl_class(0.8, 0.3, 0.1), "whirling");
  EXPECT_STREQ(whirl_class(0.6, 0.5, 0.9), "not separable");
}

}  // namespace
}  // namespace cagetol
