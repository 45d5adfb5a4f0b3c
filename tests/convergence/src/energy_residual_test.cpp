// The energy account closes better the tighter the tolerance.
#include <gtest/gtest.h>
#include <algorithm>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// Mean over starts: in so short a window the residual of one is a matter of luck.
double mean_residual(Scene scene, double tolerance) {
  scene.integration.tolerance = tolerance;
  scene.integration.max_step = 1e-3;  // that the tolerance alone decides
  scene.window.settle_time = 1e-3;
  scene.window.measure_time = 3e-3;
  scene.watch.energy_residual_max = 10;
  constexpr int kStarts = 4;
  double sum = 0;
  for (int start = 0; start < kStarts; ++start) {
    scene.start.cage_phase = start * 0.05;
    const Outcome outcome = simulate(scene);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
    sum += outcome.run.energy_residual / kStarts;
  }
  return sum;
}

TEST(EnergyResidual, FallsWithTheTolerance) {
  const Scene dry = dry_scene("nu205"), oiled = shipped_scene("nu205");
  EXPECT_LT(mean_residual(dry, 1e-4), std::min(0.02 * mean_residual(dry, 1e-1), 1e-3));
  EXPECT_LT(mean_residual(oiled, 1e-4), std::min(0.05 * mean_residual(oiled, 1e-1), 1e-3));
}

}  // namespace
}  // namespace cagetol
