// Rollers thrown at the outer race, one impact each: contact time and restitution against closed
// forms, through the integrator.
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <vector>

#include "src/integration/integrator.hpp"

namespace cagetol {
namespace {

struct Impact {
  double restitution, contact_time;
};

/// All rollers fly radially at `speed` from a gap; nothing else moves, turns or weighs.
Impact throw_rollers(const Scene& scene, double speed, double tolerance, IntegrationMethod method) {
  const BearingModel model = make_bearing_model(scene);
  const StateLayout& l = model.layout;
  const double gap = 1e-6, touch = model.outer_radius - model.nominal_diameter / 2;
  std::vector<double> y(static_cast<std::size_t>(l.size()), 0.0);
  const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
  for (int j = 0; j < l.padded(); ++j) {
    at(l.position(kRadius, j)) = touch - gap;
    at(l.position(kAngle, j)) = 2 * std::numbers::pi * j / l.rollers;
    if (j < l.rollers) at(l.velocity(kRadialSpeed, j)) = speed;
  }
  Integration keys = scene.integration;
  keys.tolerance = tolerance;
  keys.method = method;
  System system(model);
  double t = 0;
  const double end = 2e-3;
  const auto integrator = make_integrator(keys, system, t, y.data());
  while (t < end) {
    EXPECT_TRUE(system.linearise_at(t, y.data()));
    if (integrator->step(system, t, y.data(), end) != StepStatus::accepted) {
      ADD_FAILURE() << integrator->failure();
      break;
    }
  }
  const double out = -at(l.velocity(kRadialSpeed, 0)), left = touch - at(l.position(kRadius, 0));
  return {out / speed, end - left / out - gap / speed};
}

Scene thrown_scene(double restitution) {
  Scene scene;
  scene.bearing.internal_clearance = 20e-3;  // the inner race is far away
  scene.operation = {.radial_load = 0, .inner_speed = 0, .gravity = 0};
  scene.contact.race.restitution = restitution;
  scene.discretisation.race_slices = 1;
  return scene;
}

TEST(HertzImpact, ElasticContactTimeAndRestitution) {
  const Scene scene = thrown_scene(1);
  const double speed = 0.1, e = 10.0 / 9.0, n = e + 1;
  const double mass = 7810 * std::numbers::pi * 3.75e-3 * 3.75e-3 * 9e-3;
  const double K = 77652 * std::pow(9, 8.0 / 9.0) * std::pow(1e3, e);  // [N/m^e]
  const double deepest = std::pow(n * mass * speed * speed / (2 * K), 1 / n);
  // T = 2 p_max/v int_0^1 du/sqrt(1 - u^n).
  const double time = 2 * deepest / speed * std::sqrt(std::numbers::pi) * std::tgamma(1 + 1 / n) /
                      std::tgamma(0.5 + 1 / n);
  using enum IntegrationMethod;
  for (const IntegrationMethod method : {rodas3, rodasp}) {
    const Impact impact = throw_rollers(scene, speed, 1e-5, method);
    EXPECT_NEAR(impact.contact_time / time, 1, 1e-3) << spelled(method);
    EXPECT_NEAR(impact.restitution, 1, 1e-3) << spelled(method);
  }
}

TEST(HertzImpact, RestitutionAtItsReferenceSpeedAndItsErrorFallsWithTolerance) {
  const Scene scene = thrown_scene(0.9);
  double last = 1;
  for (double tolerance : {1e-2, 1e-4, 1e-6}) {
    const double error =
        std::abs(throw_rollers(scene, 0.1, tolerance, IntegrationMethod::rodas3).restitution - 0.9);
    EXPECT_LT(error, last);
    last = error;
  }
  EXPECT_LT(last, 1e-5);
}

}  // namespace
}  // namespace cagetol
