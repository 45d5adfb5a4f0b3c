#include "src/model/duty.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

namespace cagetol {
namespace {

using std::numbers::pi;

// A load at 90 degrees is along +y, one at 180 degrees along +z.
TEST(Duty, TurnsTheLoadFromMinusZTowardsPlusY) {
  Operation o;
  o.load_direction = pi / 2;
  RingLoad load = load_at(make_duty(o), 0);
  EXPECT_DOUBLE_EQ(load.y, 1000);
  EXPECT_NEAR(load.z, 0, 1e-12);
  o.load_direction = pi;
  load = load_at(make_duty(o), 0);
  EXPECT_NEAR(load.y, 0, 1e-12);
  EXPECT_DOUBLE_EQ(load.z, 1000);
}

TEST(Duty, RotatingLoadsTurnWithTheInnerRingOrAtASpeedOfTheirOwn) {
  Operation o;
  o.radial_load = 0;
  o.rotating_load = 300;
  o.inner_speed = 500;
  const double t = 1.3e-3;
  RingLoad load = load_at(make_duty(o), t);
  EXPECT_NEAR(load.y, 300 * std::sin(500 * t), 1e-10);
  EXPECT_NEAR(load.z, -300 * std::cos(500 * t), 1e-10);
  o.rotating_speed = -200;
  load = load_at(make_duty(o), t);
  EXPECT_NEAR(load.y, 300 * std::sin(-200 * t), 1e-10);
}

// 1 kg at 1 mm, 100 rad/s: 10 N.
TEST(Duty, AnUnbalancePullsWithTheSquareOfTheSpeed) {
  Operation o;
  o.radial_load = 0;
  o.unbalance = 1e-3;
  o.inner_speed = 100;
  o.rotating_phase = pi / 2;
  const RingLoad load = load_at(make_duty(o), 0);
  EXPECT_NEAR(load.y, 10, 1e-12);
  EXPECT_NEAR(load.z, 0, 1e-12);
  EXPECT_NEAR(largest_load(make_duty(o)), 10, 1e-12);
}

// Over a ramp the ring turns by its mean speed, wherever the ramp ends.
TEST(Duty, WhatTurnsWithARampedRingHasItsAngle) {
  Operation o;
  o.radial_load = 0;
  o.rotating_load = 1;
  o.speed_ramp_from = 100;
  o.inner_speed = 300;
  o.speed_ramp = 2e-3;
  const auto angle = [&](double t) {
    const RingLoad load = load_at(make_duty(o), t);
    return std::atan2(load.y, -load.z);
  };
  EXPECT_NEAR(angle(2e-3), 200 * 2e-3, 1e-12);
  EXPECT_NEAR(angle(3e-3), 200 * 2e-3 + 300 * 1e-3, 1e-12);
  const double dt = 1e-6;
  for (const double t : {0.5e-3, 1e-3, 1.7e-3})
    EXPECT_NEAR((angle(t + dt) - angle(t - dt)) / (2 * dt), ring_speeds_at(make_duty(o), t).inner,
                1e-3);
}

TEST(Duty, TheHeaviestLoadAddsWhatTurnsToTheRest) {
  Operation o;
  o.radial_load = 1000;
  o.load_direction = pi / 2;
  o.rotating_load = 200;
  o.unbalance = 1e-3;
  o.inner_speed = 1000;
  EXPECT_NEAR(largest_load(make_duty(o)), 2200, 1e-9);
  EXPECT_NEAR(heaviest_load(make_duty(o)).y, 2200, 1e-9);
}

}  // namespace
}  // namespace cagetol
