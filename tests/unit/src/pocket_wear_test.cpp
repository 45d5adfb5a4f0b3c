// Measures of wear at the bars: impulse and work of friction of a revolution of the cage.
#include <gtest/gtest.h>
#include <numbers>

#include "src/integration/system.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// Sums over a run by the trapezium rule, apart from the observer.
struct Sums {
  double impulse = 0, work = 0, turned = 0;
};

TEST(PocketWear, IsImpulseAndWorkOfARevolution) {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_revolutions = 0.2;
  scene.window.measure_revolutions = 1.5;
  scene.integration.max_step = 10e-6;
  scene.watch.static_consistency_max = scene.watch.energy_residual_max = 1;
  scene.watch.cage_drift_max = scene.watch.power_surplus_max = 1e9;
  Sums sums;
  double before_t = -1, before_force = 0, before_power = 0, first_angle = 0;
  const double settled = [&] {
    const double pitch = 39e-3, ratio = 7.5e-3 / pitch;
    return 0.2 * 2 * std::numbers::pi / (scene.operation.inner_speed * (1 - ratio) / 2);
  }();
  const Outcome outcome = simulate(
      scene, {.on_state = [&](double t, const double* y, const System& system) {
        if (t < 0.999 * settled) return;
        const StateLayout& l = system.model.layout;
        double force = 0;
        for (int j = 0; j < l.rollers; ++j) {
          const auto k = static_cast<std::size_t>(j);
          force += (system.seen.leading_force[k] + system.seen.trailing_force[k]) / l.rollers;
        }
        const double power = system.seen.lost[kPocketFriction] / l.rollers;
        const double angle = y[l.border_position(kCagePhi)];
        if (before_t < 0) first_angle = angle;
        if (before_t >= 0) {
          sums.impulse += 0.5 * (t - before_t) * (force + before_force);
          sums.work += 0.5 * (t - before_t) * (power + before_power);
        }
        sums.turned = (angle - first_angle) / (2 * std::numbers::pi);
        before_t = t, before_force = force, before_power = power;
      }});
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  ASSERT_GT(sums.impulse, 0);
  EXPECT_NEAR(quantity(outcome, "pocket_impulse_N_s"), sums.impulse / sums.turned,
              0.01 * sums.impulse / sums.turned);
  EXPECT_NEAR(quantity(outcome, "pocket_friction_work_J"), sums.work / sums.turned,
              0.01 * sums.work / sums.turned);
}

}  // namespace
}  // namespace cagetol
