// The bearings of other kinds that inputs/scenes ships run, each with a rigid cage for a moment.
#include <gtest/gtest.h>
#include <cmath>

#include "src/heat_balance.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

class ShippedBearings : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Scenes, ShippedBearings,
                         testing::Values("nu208-brass", "nj308-axial", "nu2322-gearbox",
                                         "nu226-axlebox", "nu2206-moulded", "nu208-planet",
                                         "n1014-spindle", "aero118-outer", "aero118-inner",
                                         "bore10-small"),
                         [](const auto& test) {
                           std::string name = test.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

TEST_P(ShippedBearings, Run) {
  Scene scene = with_temperature_found(shipped_scene(GetParam()));
  EXPECT_EQ(scene.name, GetParam());
  scene.cage.model = CageKind::rigid;
  scene.window.settle_revolutions = 0.5;
  scene.window.measure_revolutions = 0.5;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  // Loaded by a tenth of their rating, rollers hold cages to their rolling speed.
  EXPECT_LT(std::abs(quantity(outcome, "driving_slip_ratio")), 0.05);
  EXPECT_GT(std::abs(quantity(outcome, "friction_torque_Nmm")), 10);
  EXPECT_LT(outcome.run.energy_residual, 0.005);
}

// Rollers that stand straight under 1.9 GPa all but stick: their traction turns over within
// nanometres a second, and the account must not take it for a rate that lasts a whole step.
TEST(StickingRollers, CloseTheEnergyAccount) {
  Scene scene = shipped_scene("bore10-small");
  scene.cage.model = CageKind::rigid;
  scene.bearing.misalignment_z = 0;
  scene.window.settle_revolutions = 0.5;
  scene.window.measure_revolutions = 0.5;
  for (const double phase : {0.0, 0.1, 0.2, 0.3}) {
    scene.start.cage_phase = phase;
    const Outcome outcome = simulate(scene);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
    EXPECT_LT(outcome.run.energy_residual, 0.01) << phase;
  }
}

}  // namespace
}  // namespace cagetol
