// Tables over time as the right-hand side reads them.
#include "src/model/duty_course.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/model/duty.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

Operation ramped() {
  Operation o;
  o.axial_load = 7;
  o.table.time = {{1e-3, 3e-3, 4e-3}};
  o.table.inner_speed = {{0, 200, -100}};
  o.table.radial_load = {{500, 500, 900}};
  o.table.direction = {{0, pi / 2, pi / 2}};
  return o;
}

TEST(DutyCourse, LiesOnStraightLinesBetweenRowsAndHoldsBeyond) {
  const Duty duty = make_duty(ramped());
  const double slope = 200 / 2e-3;
  EXPECT_EQ(ring_speeds_at(duty, 0).inner, 0);
  EXPECT_DOUBLE_EQ(ring_speeds_at(duty, 1.7e-3).inner, slope * 0.7e-3);
  EXPECT_DOUBLE_EQ(ring_speeds_at(duty, 3.5e-3).inner, 50);
  EXPECT_EQ(ring_speeds_at(duty, 1).inner, -100);
  const RingLoad between = load_at(duty, 2e-3);
  EXPECT_NEAR(between.y, 500 * std::sin(pi / 4), 1e-10);
  EXPECT_NEAR(between.z, -500 * std::cos(pi / 4), 1e-10);
  EXPECT_NEAR(load_at(duty, 3.5e-3).y, 700, 1e-10);
  EXPECT_NEAR(load_at(duty, 9).y, 900, 1e-10);
  EXPECT_EQ(load_at(duty, 2e-3).axial, 7);  // a column left out
  EXPECT_NEAR(largest_load(duty), 900, 1e-10);
  EXPECT_EQ(fastest_speeds(duty).inner, 200);
}

TEST(DutyCourse, TurnsTheRingsByTheIntegralOfTheirSpeeds) {
  Operation o = ramped();
  o.table.outer_speed = {{-10, 40, 40}};
  for (const double repeat : {kAuto, 3.5e-3}) {
    o.table.repeat = repeat;
    const Duty duty = make_duty(o);
    const double h = 1e-7;
    RingAngles sum;
    for (int n = 0; n < 150000; ++n) {
      const RingSpeeds at = ring_speeds_at(duty, (n + 0.5) * h);
      sum.inner += h * at.inner;
      sum.outer += h * at.outer;
    }
    const RingAngles turned = ring_angles_at(duty, 15e-3);
    EXPECT_NEAR(turned.inner, sum.inner, 1e-5) << repeat;
    EXPECT_NEAR(turned.outer, sum.outer, 1e-5) << repeat;
  }
}

TEST(DutyCourse, RepeatsAfterItsPeriodWithALineFromTheLastRowToTheFirst) {
  Operation o = ramped();
  o.table.repeat = 5e-3;
  const Duty duty = make_duty(o);
  EXPECT_DOUBLE_EQ(ring_speeds_at(duty, 5e-3).inner, -50);
  for (const double t : {1.1e-3, 2.9e-3, 3.9e-3, 5.5e-3})
    for (const int k : {1, 2, 40})
      EXPECT_NEAR(ring_speeds_at(duty, t + k * 5e-3).inner, ring_speeds_at(duty, t).inner, 1e-8);
  EXPECT_TRUE(duty_changes(duty, 100));
}

TEST(DutyCourse, NamesTheCornersInOrder) {
  Operation o = ramped();
  const DutyCourse once(o);
  EXPECT_EQ(once.next_corner(0), 1e-3);
  EXPECT_EQ(once.next_corner(1e-3), 3e-3);
  EXPECT_EQ(once.next_corner(1e-3 - 1e-16), 3e-3);  // rounding does not make a corner twice
  EXPECT_EQ(once.next_corner(4e-3), std::numeric_limits<double>::infinity());
  o.table.repeat = 5e-3;
  const DutyCourse again(o);
  double t = 0;
  for (const double corner : {1e-3, 3e-3, 4e-3, 6e-3, 8e-3, 9e-3, 11e-3, 13e-3}) {
    t = again.next_corner(t);
    EXPECT_NEAR(t, corner, 1e-15);
  }
}

}  // namespace
}  // namespace cagetol
