// The energy account closes better the tighter the tolerance.
#include <gtest/gtest.h>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

TEST(EnergyResidual, FallsWithTheTolerance) {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_time = 1e-3;
  scene.window.measure_time = 3e-3;
  scene.watch.energy_residual_max = 10;
  double first = 0, last = 1e9;
  for (double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    scene.integration.tolerance = tolerance;
    const Outcome outcome = simulate(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    if (first == 0) first = outcome.run.energy_residual;
    last = outcome.run.energy_residual;
  }
  EXPECT_LT(last, 0.02 * first);
  EXPECT_LT(last, 1e-3);
}

}  // namespace
}  // namespace cagetol
