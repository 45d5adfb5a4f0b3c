// How a step's error counts: bouncing speeds in a larger unit, while the energy they move is small.
#include "src/integration/step_error.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "src/dynamics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kTolerance = 1e-3, kStep = 1e-5, kPower = 2;  // [-], [s], [W]

class StepErrorOf : public testing::Test {
 protected:
  StepErrorOf() { prepare(); }

  void prepare() {
    model_ = make_bearing_model(scene_);
    system_ = std::make_unique<System>(model_);
    y_ = start_state(model_, scene_.start);
    system_->linearise_at(0, y_.data());
    const StateLayout& l = model_.layout;
    for (int j = 0; j < l.rollers; ++j) {
      y_[at(kRadialSpeed, j)] = 0;
      system_->rate[at(kRadialSpeed, j)] = 0;
    }
    for (GroupLinear& rollers : system_->linear.groups) rollers.velocity[kLr][kLr] = Pack{};
    system_->seen.damping_power = 0;
    system_->seen.friction_power = kPower;
    error_.assign(y_.size(), 0.0);
  }
  std::size_t at(RollerVelocity slot, int roller) const {
    return static_cast<std::size_t>(model_.layout.velocity(slot, roller));
  }
  /// After `still` without dissipation and `time` of it.
  double counted(double time, double still = 0, double bounce_share = 1) const {
    StepError judged(bounce_share);
    if (still > 0) {
      const double power = std::exchange(system_->seen.friction_power, 0);
      judged.advance(*system_, still);
      system_->seen.friction_power = power;
    }
    if (time > 0) judged.advance(*system_, time);
    return judged(*system_, y_.data(), error_.data(), kStep, kTolerance);
  }
  double strict() const { return error_norm(*system_, error_.data()) / kTolerance; }

  Scene scene_ = dry_scene("nu205");
  BearingModel model_;
  std::unique_ptr<System> system_;
  std::vector<double> y_, error_;
};

constexpr double kLong = 1;  // [s], a thousand times as long as the dissipation is averaged

TEST_F(StepErrorOf, BounceOfARollerCountsInUnitsOfTenCentimetresASecond) {
  error_[at(kRadialSpeed, 3)] = 1e-3;
  EXPECT_NEAR(counted(kLong), strict() / 10, 1e-12 * strict());
}

TEST_F(StepErrorOf, PlaceOfARollerCountsInUnitsOfThreeMicrometresUnlessTheRacesPressIt) {
  error_[static_cast<std::size_t>(model_.layout.position(kRadius, 3))] = 1e-9;
  system_->seen.inner_force[3] = 0;
  EXPECT_NEAR(counted(kLong), strict() / 3, 1e-12 * strict());
  system_->seen.inner_force[3] = 1;
  EXPECT_NEAR(counted(kLong), strict(), 1e-12 * strict());
}

// Along its own motion a roller is early or late: v dv = a dx.
TEST_F(StepErrorOf, AShiftOfPhaseMovesNoEnergy) {
  const double speed = 0.1, acceleration = 1e4, early = 1e-8;
  system_->seen.inner_force[3] = 0;
  y_[at(kRadialSpeed, 3)] = speed;
  system_->rate[at(kRadialSpeed, 3)] = acceleration;
  error_[at(kRadialSpeed, 3)] = acceleration * early;
  error_[static_cast<std::size_t>(model_.layout.position(kRadius, 3))] = speed * early;
  EXPECT_LT(counted(kLong), strict() / 5);
  error_[at(kRadialSpeed, 3)] *= -1;  // less speed, but farther up
  const double moved = 2 * model_.groups[0].mass[3] * speed * acceleration * early;
  EXPECT_NEAR(counted(kLong), moved / (0.02 * kPower * kStep), 1e-9);
}

TEST_F(StepErrorOf, TiltAndSkewAreNotBouncing) {
  const double angle = y_[static_cast<std::size_t>(model_.layout.position(kAngle, 3))];
  const auto lean = [&](double y, double z) {
    for (double* of : {y_.data(), system_->rate.data()})
      of[at(kAxisRateY, 3)] = of[at(kAxisRateZ, 3)] = 0;
    error_[at(kAxisRateY, 3)] = 0.1 * y;
    error_[at(kAxisRateZ, 3)] = 0.1 * z;
  };
  lean(std::cos(angle), std::sin(angle));
  EXPECT_NEAR(counted(kLong), strict(), 1e-12 * strict());
  lean(-std::sin(angle), std::cos(angle));
  EXPECT_NEAR(counted(kLong), strict(), 1e-12 * strict());
}

TEST_F(StepErrorOf, OtherSpeedsCountInFull) {
  error_[at(kAxialSpeed, 5)] = 1e-3;
  error_[at(kSpin, 3)] = 1;
  error_[static_cast<std::size_t>(model_.layout.border_velocity(kCageY))] = 1e-3;
  EXPECT_DOUBLE_EQ(counted(kLong), strict());
}

TEST_F(StepErrorOf, EverythingCountsInFullWhereNothingDissipates) {
  error_[at(kRadialSpeed, 3)] = 1e-3;
  y_[at(kRadialSpeed, 3)] = 1e-3;
  EXPECT_DOUBLE_EQ(counted(0), strict());
}

TEST_F(StepErrorOf, EnergyMovedIsBoundByOneFiftiethOfTheDissipated) {
  const double mass = model_.groups[0].mass[3], e = 2e-4;
  error_[at(kRadialSpeed, 3)] = e;
  // Between a tenth of the error and all of it.
  const double wanted = 0.5 * strict();
  y_[at(kRadialSpeed, 3)] = wanted * 0.02 * kPower * kStep / (mass * e);
  EXPECT_NEAR(counted(kLong), wanted, 1e-9 * wanted);
  // A place moves energy where a force acts on the roller beyond its inertia's balance.
  error_[static_cast<std::size_t>(model_.layout.position(kRadius, 3))] = 1e-12;
  system_->rate[at(kRadialSpeed, 3)] = -1e4;
  EXPECT_NEAR(counted(kLong), wanted + mass * 1e-8 / (0.02 * kPower * kStep), 1e-6 * wanted);
}

TEST_F(StepErrorOf, DissipationIsAveragedOverAMillisecond) {
  error_[at(kRadialSpeed, 3)] = 2e-4;
  y_[at(kRadialSpeed, 3)] =
      0.3 * strict() * 0.02 * kPower * kStep / (model_.groups[0].mass[3] * 2e-4);
  // Over the time there was: a start is no quiet past.
  EXPECT_NEAR(counted(1e-4), 0.3 * strict(), 1e-9 * strict());
  const double power = (1 - std::exp(-1.0)) / (1 - std::exp(-2.0));
  EXPECT_NEAR(counted(1e-3, 1e-3), 0.3 * strict() / power, 1e-9 * strict());
}

TEST_F(StepErrorOf, OfBouncingAMethodsShareOfTheEstimateCounts) {
  const double e = 1e-3;
  error_[at(kRadialSpeed, 3)] = e;
  EXPECT_NEAR(counted(kLong, 0, 0.5), strict() / 20, 1e-12 * strict());
  y_[at(kRadialSpeed, 3)] = 0.4 * strict() * 0.02 * kPower * kStep / (model_.groups[0].mass[3] * e);
  EXPECT_NEAR(counted(kLong, 0, 1), 0.4 * strict(), 1e-9 * strict());
  EXPECT_NEAR(counted(kLong, 0, 0.5), 0.2 * strict(), 1e-9 * strict());
  error_[at(kSpin, 3)] = 100;  // what is not spared counts in full
  const double spin = 100 * system_->per_scale[at(kSpin, 3)] / kTolerance;
  EXPECT_NEAR(counted(kLong, 0, 0.5), spin / std::sqrt(system_->components), 1e-2 * strict());
}

// What the dashpot takes of a speed in error, where it stops the roller within the step.
TEST_F(StepErrorOf, PowerInErrorIsMovedEnergyWhereADashpotStopsARollerWithinTheStep) {
  const double e = 1e-3, slope = 200, mass = model_.groups[0].mass[3];
  error_[at(kRadialSpeed, 3)] = e;
  GroupLinear& roller = system_->linear.groups[0];
  roller.power_velocity[kLr][3] = slope;
  const double all = slope * e * kStep / (0.02 * kPower * kStep);
  ASSERT_GT(all, 2 * strict() / 10);
  for (const double stops : {0.0, 0.5, 3.0, 100.0}) {
    roller.velocity[kLr][kLr][3] = -stops * mass / kStep;
    const double counts = stops * stops / (1 + stops * stops) * all;
    EXPECT_NEAR(counted(kLong), std::clamp(counts, strict() / 10, strict()), 1e-9 * strict())
        << stops;
  }
  error_[at(kRadialSpeed, 3)] = 0;
  error_[static_cast<std::size_t>(model_.layout.position(kRadius, 3))] = 1e-9;
  system_->seen.inner_force[3] = 0;
  ASSERT_LT(counted(kLong), 0.03);
  roller.power_position[kLr][3] = 2e6;
  EXPECT_NEAR(counted(kLong), 0.05, 1e-5);
}

TEST_F(StepErrorOf, ASpeedsScaleIsNoCoarserThanFrictionsOwnSpeed) {
  const auto scale = [&](double static_speed) {
    scene_.contact.static_speed = static_speed;
    scene_.contact.dynamic_speed = 10 * static_speed;
    prepare();
    return system_->scale[at(kRadialSpeed, 3)];
  };
  EXPECT_DOUBLE_EQ(scale(0.1), 0.01);
  EXPECT_DOUBLE_EQ(scale(0.02), 0.01);
  EXPECT_DOUBLE_EQ(scale(0.001), 0.001);
}

TEST_F(StepErrorOf, NoUnitIsCoarserThanFrictionsOwnSpeed) {
  scene_.contact.static_speed = 0.001;
  scene_.contact.dynamic_speed = 0.01;
  prepare();
  error_[at(kRadialSpeed, 3)] = 1e-3;
  EXPECT_DOUBLE_EQ(counted(kLong), strict());
  scene_.contact.static_speed = 0.02;
  scene_.contact.dynamic_speed = 0.2;
  prepare();
  error_[at(kRadialSpeed, 3)] = 1e-3;
  EXPECT_NEAR(counted(kLong), strict() / 2, 1e-12 * strict());
}

TEST_F(StepErrorOf, RatesOfSkewAndAxialSpeedCountMoreInTouches) {
  const double most = 1 / 0.065;
  system_->seen.inner_force[3] = 0;
  const double angle = y_[static_cast<std::size_t>(model_.layout.position(kAngle, 3))];
  const auto lean = [&](double tilt, double skew) {
    error_[at(kAxisRateY, 3)] = std::cos(angle) * tilt - std::sin(angle) * skew;
    error_[at(kAxisRateZ, 3)] = std::sin(angle) * tilt + std::cos(angle) * skew;
  };
  const auto expect_counted = [&](double times) {
    EXPECT_NEAR(counted(kLong), times * strict(), 1e-10 * strict());
    EXPECT_NEAR(counted(0), times * strict(), 1e-10 * strict());
  };
  lean(0, 1e-3);
  expect_counted(1);
  system_->seen.flange_force[3] = 1;
  expect_counted(most);
  system_->seen.inner_force[3] = 1;  // pressed between the races
  expect_counted(1);
  system_->seen.inner_force[3] = 0;
  lean(1e-3, 0);
  expect_counted(1);
  lean(0, 0);
  error_[at(kAxialSpeed, 3)] = 1e-5;
  expect_counted(most);
  error_[at(kAxialSpeed, 3)] = 0;
  error_[at(kAxialSpeed, 4)] = 1e-5;
  expect_counted(1);
  for (auto* bar : {&system_->seen.leading_force, &system_->seen.trailing_force}) {
    (*bar)[4] = 1;
    system_->seen.inner_force[4] = 0;
    expect_counted(1);
    error_[at(kAxialSpeed, 4)] = 0;
    const double turned = y_[static_cast<std::size_t>(model_.layout.position(kAngle, 4))];
    error_[at(kAxisRateY, 4)] = -1e-3 * std::sin(turned);
    error_[at(kAxisRateZ, 4)] = 1e-3 * std::cos(turned);
    expect_counted(most);
    system_->seen.inner_force[4] = 1;
    expect_counted(1);
    error_[at(kAxisRateY, 4)] = error_[at(kAxisRateZ, 4)] = 0;
    error_[at(kAxialSpeed, 4)] = 1e-5;
    (*bar)[4] = 0;
  }
}

TEST_F(StepErrorOf, WhatIsNotANumberStaysNone) {
  error_[at(kRadialSpeed, 3)] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(counted(kLong) <= 1);
  error_[at(kRadialSpeed, 3)] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(counted(kLong) <= 1);
}

}  // namespace
}  // namespace cagetol
