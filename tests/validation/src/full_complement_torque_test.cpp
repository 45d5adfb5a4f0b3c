// Friction torque of a full complement bearing beside SKF's model (General Catalogue), in N mm:
//   M = phi_ish phi_rs R1 d_m^2.41 F^0.31 (nu n)^0.6 + mu_sl S2 d_m F
// with R1 = 2.13e-6 of full complements (of bearings with cages of series 10: 1.12e-6).
#include <gtest/gtest.h>
#include <cmath>

#include "src/lubrication/lubricant.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

double skf_torque(const Scene& scene, double rolling_factor) {
  const double d = 1e3 * scene.bearing.bore_diameter, D = 1e3 * scene.bearing.outside_diameter,
               mean = (d + D) / 2, F = scene.operation.radial_load,
               n = scene.operation.inner_speed / 0.10471975511965977;
  const Oil& oil = lubricant_named(scene.lubrication.lubricant).oil;
  const double nu = kinematic_viscosity(viscosity_curve(oil.viscosity_40, oil.viscosity_100),
                                        scene.lubrication.temperature),
               shear = nu * n;
  const double heating = 1 / (1 + 1.84e-9 * std::pow(n * mean, 1.28) * std::pow(nu, 0.64)),
               filling = std::exp(-3e-8 * shear * (d + D) * std::sqrt(5.1 / (2 * (D - d))));
  const double boundary = std::exp(-2.6e-8 * std::pow(shear, 1.4) * mean),
               friction = 0.15 * boundary + 0.02 * (1 - boundary);
  return heating * filling * rolling_factor * std::pow(mean, 2.41) * std::pow(F, 0.31) *
             std::pow(shear, 0.6) +
         friction * 0.0015 * mean * F;
}

// 0.56 of SKF's model: more than rollers with a cage would take, less than it gives for rollers
// without. Where the rest goes is not known; rollers that rub on each other take an eighth.
TEST(FullComplementTorque, IsSomeHalfOfSkfs) {
  Scene scene = shipped_scene("ncf3008-full-complement");
  scene.window.settle_revolutions = 1;
  scene.window.measure_revolutions = 2;
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  const double torque = quantity(outcome, "friction_torque_Nmm");
  const double share = torque / skf_torque(scene, 2.13e-6);
  RecordProperty("torque", std::to_string(torque));
  RecordProperty("share_of_skf", std::to_string(share));
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 1.6);
  EXPECT_GT(torque, skf_torque(scene, 1.12e-6));
  EXPECT_GT(quantity(outcome, "power_neighbour_W"), 0.05 * quantity(outcome, "power_loss_W"));
}

}  // namespace
}  // namespace cagetol
