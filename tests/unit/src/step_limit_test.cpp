// Where steps end: touches, partings, young contacts, of one contact and of a pack of them.
#include "src/dynamics/step_limit.hpp"

#include <gtest/gtest.h>

namespace cagetol {
namespace {

constexpr double kStepHorizon = 1e-3;  // [s]

constexpr double kClosingSpeed = 2e-3;  // [m/s]

double after_touch_in(double time, double speed = kClosingSpeed) {
  StepLimit<double> limit(kStepHorizon);
  limit.touch(-time * speed, speed, true);
  return limit.longest();
}

TEST(StepLimit, IsTheHorizonWhereNothingChanges) {
  EXPECT_EQ(StepLimit<double>(kStepHorizon).longest(), kStepHorizon);
  EXPECT_EQ(after_touch_in(1.1 * kStepHorizon), kStepHorizon);
  EXPECT_EQ(after_touch_in(1e-6, -kClosingSpeed), kStepHorizon);  // closed, parting
  StepLimit<double> limit(kStepHorizon);
  limit.touch(-1e-9, -kClosingSpeed, true);  // open, going away
  limit.touch(1e-9, kClosingSpeed, true);    // closed already
  EXPECT_EQ(limit.longest(), kStepHorizon);
}

TEST(StepLimit, StepsEndJustBeforeATouchAndFromThereJustInside) {
  EXPECT_NEAR(after_touch_in(10e-6), 9.9e-6, 1e-12);
  EXPECT_NEAR(after_touch_in(0.61e-6), 0.51e-6, 1e-12);
  EXPECT_NEAR(after_touch_in(0.1e-6), 0.6e-6, 1e-12);
  EXPECT_NEAR(after_touch_in(0), kStepHorizon, 0);  // at the touch itself: not ahead
  EXPECT_NEAR(after_touch_in(1e-12), 0.5e-6, 1e-11);
}

TEST(StepLimit, TheNearestChangeCounts) {
  StepLimit<double> limit(kStepHorizon);
  limit.touch(-20e-6 * kClosingSpeed, kClosingSpeed, true);
  limit.touch(-8e-6 * kClosingSpeed, kClosingSpeed, true);
  limit.touch(-30e-6 * kClosingSpeed, kClosingSpeed, true);
  EXPECT_NEAR(limit.longest(), 7.9e-6, 1e-12);
  limit.pass(-6e-6 * kClosingSpeed, kClosingSpeed, true);  // over it, and half a microsecond on
  EXPECT_NEAR(limit.longest(), 6.5e-6, 1e-12);
  limit.pass(-4.5e-6 * kClosingSpeed, kClosingSpeed, true);
  EXPECT_NEAR(limit.longest(), 5e-6, 1e-12);
  limit.at_most(4e-6, false);
  EXPECT_NEAR(limit.longest(), 5e-6, 1e-12);
  limit.at_most(4e-6, true);
  EXPECT_NEAR(limit.longest(), 4e-6, 1e-12);
}

TEST(StepLimit, AYoungContactGrowsBySteps) {
  const auto at_age = [](double age) {
    StepLimit<double> limit(kStepHorizon);
    limit.grow(age * kClosingSpeed, kClosingSpeed, true);
    return limit.longest();
  };
  EXPECT_NEAR(at_age(0.5e-6), 2e-6, 1e-12);
  EXPECT_NEAR(at_age(3e-6), 12e-6, 1e-12);
  EXPECT_NEAR(at_age(0.01e-6), 0.5e-6, 1e-12);
  EXPECT_EQ(at_age(1), kStepHorizon);
  StepLimit<double> parting(kStepHorizon);
  parting.grow(1e-9, -kClosingSpeed, true);
  EXPECT_EQ(parting.longest(), kStepHorizon);
}

TEST(StepLimit, StepsAreLaidAroundTheNearestTouch) {
  StepLimit<double> limit(kStepHorizon);
  limit.lay_around(8e-6 * kClosingSpeed, kClosingSpeed, true);     // closed already
  limit.lay_around(-8e-6 * kClosingSpeed, -kClosingSpeed, true);   // going away
  limit.lay_around(-1.1e-3 * kClosingSpeed, kClosingSpeed, true);  // beyond the horizon
  limit.lay_around(-2e-6 * kClosingSpeed, kClosingSpeed, false);
  EXPECT_EQ(limit.touch_ahead(), kNoTouch);
  for (const double ahead : {20e-6, 8e-6, 30e-6})
    limit.lay_around(-ahead * kClosingSpeed, kClosingSpeed, true);
  EXPECT_NEAR(limit.touch_ahead(), 8e-6, 1e-15);
  EXPECT_EQ(limit.longest(), kStepHorizon);

  const auto length = [](double in, double h) { return laid_around(in, 0.4, 4e-6, h); };
  EXPECT_EQ(length(8e-6, 7e-6), 7e-6);  // not reached
  EXPECT_EQ(length(kNoTouch, 20e-6), 20e-6);
  EXPECT_NEAR(length(8e-6, 12e-6), 7.2e-6, 1e-15);  // ends half its reach before it, ...
  EXPECT_NEAR(length(0.8e-6, 12e-6), 2e-6, 1e-15);  // ... and has it at its place then
  EXPECT_NEAR(length(1.5e-6, 20e-6), 3.75e-6, 1e-15);
  EXPECT_NEAR(length(1.5e-6, 2e-6), 1.1e-6, 1e-15);  // a short step stays short
  EXPECT_NEAR(length(0.6e-6, 2e-6), 1.5e-6, 1e-15);
  EXPECT_NEAR(length(1e-9, 20e-6), kNearestTouch / 0.4, 1e-15);
  EXPECT_NEAR(laid_around(5e-6, 0, 4e-6, 20e-6), 7.5e-6, 1e-15);  // runs over it
  EXPECT_EQ(laid_around(5e-6, 0, 4e-6, 6e-6), 6e-6);
}

TEST(StepLimit, PacksSeeWhatEachOfTheirContactsSees) {
  StepLimit<Pack> pack(kStepHorizon);
  Pack p, rate;
  Mask here;
  for (int lane = 0; lane < kLanes; ++lane) {
    p[lane] = (lane - 4) * 3e-9;
    rate[lane] = lane % 3 == 2 ? -kClosingSpeed : kClosingSpeed;
    here[lane] = lane == 3 ? 0 : -1;
  }
  pack.touch(p, rate, here);
  pack.pass(-p, -rate, here);
  pack.grow(p, rate, here);
  pack.at_most(2e-6, here & (p > 7e-9));
  pack.lay_around(p, rate, here);
  for (int lane = 0; lane < kLanes; ++lane) {
    StepLimit<double> one(kStepHorizon);
    const bool exists = here[lane] != 0;
    one.touch(p[lane], rate[lane], exists);
    one.pass(-p[lane], -rate[lane], exists);
    one.grow(p[lane], rate[lane], exists);
    one.at_most(2e-6, exists && p[lane] > 7e-9);
    one.lay_around(p[lane], rate[lane], exists);
    EXPECT_EQ(pack.longest()[lane], one.longest()) << lane;
    EXPECT_EQ(pack.touch_ahead()[lane], one.touch_ahead()) << lane;
  }
}

}  // namespace
}  // namespace cagetol
