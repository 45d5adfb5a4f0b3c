// Steps about rolling, where the traction of a thin film under high pressure turns over within
// 1e-6 m/s.
#include <gtest/gtest.h>

#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// An NU 205 at a seventh of its rating, slow and with half a roughness of oil.
Scene slow_heavy_scene() {
  Scene scene = shipped_scene("nu205");
  scene.operation.radial_load = 3981;
  scene.operation.inner_speed /= 6;
  scene.lubrication.temperature = 50;
  scene.window = {.settle_revolutions = 0.5, .measure_revolutions = 1, .peak_revolutions = 1};
  return scene;
}

double slip_of(const Outcome& outcome) {
  return outcome.quantities[static_cast<std::size_t>(quantity_index("driving_slip_ratio"))];
}

// One roller's spin went from 0.8 mm/s on one side of rolling to as much on the other in steps of
// 60 ns, until the budget of steps was spent.
TEST(Chatter, AboutRollingEndsAfterFewSteps) {
  Scene scene = slow_heavy_scene();
  scene.integration.method = IntegrationMethod::rodas3;
  scene.integration.tolerance = 0.015;
  scene.integration.step_budget = 100000;
  const Outcome coarse = simulate(scene);
  ASSERT_EQ(coarse.status, Status::ok) << coarse.reason;
  EXPECT_LT(coarse.run.steps, 10000);
  scene.integration.method = IntegrationMethod::rodasp;
  scene.integration.tolerance = 0.001;
  const Outcome fine = simulate(scene);
  ASSERT_EQ(fine.status, Status::ok) << fine.reason;
  EXPECT_NEAR(slip_of(coarse), slip_of(fine), 0.01 * slip_of(fine));
}

}  // namespace
}  // namespace cagetol
