// Motions with closed forms through every integration method: a body bouncing to rest in ever
// shorter bounces (Zeno), and a pendulum on a stiff rod (Hairer and Wanner, Solving ODEs II,
// VII.1). Both are rollers at the bottom of the outer ring, without friction and far from
// everything else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "src/integration/integrator.hpp"

namespace cagetol {
namespace {

constexpr double kPi = std::numbers::pi, kBottom = -kPi / 2;

Scene lonely_scene(double gravity) {
  Scene scene;
  scene.bearing.internal_clearance = 20e-3;
  scene.operation = {.radial_load = 0, .inner_speed = 0, .gravity = gravity};
  scene.operation.radial_load = -make_bearing_model(scene).ring_mass * gravity;  // carries the ring
  scene.cage.guidance = Guidance::roller;
  scene.contact.friction_static = scene.contact.friction_dynamic = 0;
  scene.discretisation.race_slices = 1;
  return scene;
}

/// All rollers at one place, in pockets of a metre: nothing but the outer race meets them.
struct LonelyRollers {
  BearingModel model;
  System system;
  std::vector<double> y;
  double t = 0;
  std::unique_ptr<Integrator> integrator;

  LonelyRollers(const Scene& scene, IntegrationMethod method, double angle, double gap)
      : model(wide(make_bearing_model(scene))),
        system(model),
        y(static_cast<std::size_t>(model.layout.size()), 0.0) {
    for (int j = 0; j < model.layout.rollers; ++j) {
      y[static_cast<std::size_t>(model.layout.position(kRadius, j))] = race() - gap;
      y[static_cast<std::size_t>(model.layout.position(kAngle, j))] = angle;
    }
    for (int j = model.layout.rollers; j < model.layout.padded(); ++j)
      y[static_cast<std::size_t>(model.layout.position(kRadius, j))] = race() - gap;
    Integration keys = scene.integration;
    keys.method = method;
    // At the default tolerance these miss the instant of the sixth bounce by 1.3 and 1.0 %.
    if (method == IntegrationMethod::cvode_bdf || method == IntegrationMethod::arkode_esdirk)
      keys.tolerance /= 2;
    integrator = make_integrator(keys, system, t, y.data());
  }
  static BearingModel wide(BearingModel m) {
    for (RollerGroup& g : m.groups) {
      g.half_width += 1.0;
      g.half_length += 1.0;
    }
    return m;
  }
  double race() const { return model.outer_radius - model.nominal_diameter / 2; }
  double get(RollerPosition slot) const {
    return y[static_cast<std::size_t>(model.layout.position(slot, 0))];
  }
  double get(RollerVelocity slot) const {
    return y[static_cast<std::size_t>(model.layout.velocity(slot, 0))];
  }
  bool step(double end) {
    if (!system.linearise_at(t, y.data())) return false;
    return integrator->step(system, t, y.data(), end) == StepStatus::accepted;
  }
};

class ClosedFormMotion : public testing::TestWithParam<IntegrationMethod> {};

// A linear spring and damper that never pulls keeps the share e of every speed (Schwager and
// Poeschel, Granular Matter 9 (2007) 465, eq. 17): speeds fall like e^n, flights last 2 v/g each.
TEST_P(ClosedFormMotion, BouncesToRest) {
  const double gravity = 100, fall = 50e-6, stiffness = 1e9, zeta = 0.1;
  Scene scene = lonely_scene(gravity);
  LonelyRollers any(scene, GetParam(), kBottom, fall);
  const double mass = any.model.groups[0].mass[0];
  const double omega0 = std::sqrt(stiffness / mass), beta = zeta * omega0;
  const double omega = std::sqrt(omega0 * omega0 - beta * beta);
  scene.contact.race = {.law = ForceLaw::impact,
                        .stiffness = stiffness * 1e-3,  // of the scene: N/mm
                        .exponent = 1,
                        .damping = 2 * beta * mass,
                        .damping_depth = 1e-12};
  LonelyRollers ball(scene, GetParam(), kBottom, fall);
  const double contact = (kPi - std::atan2(2 * beta * omega, omega * omega - beta * beta)) / omega;
  const double e = std::exp(-beta * contact);
  double speed = std::sqrt(2 * gravity * fall), due = std::sqrt(2 * fall / gravity);
  bool inside = false;
  for (int bounces = 0; bounces < 6;) {
    ASSERT_TRUE(ball.step(1)) << ball.integrator->failure();
    const double gap = ball.race() - ball.get(kRadius), v = ball.get(kRadialSpeed);
    if (gap < 0) inside = true;
    if (!inside || gap < 0) continue;
    inside = false;
    ++bounces;
    speed *= e;
    due += contact;
    const double left = std::sqrt(v * v + 2 * gravity * gap);  // speed it left the race with
    EXPECT_NEAR(left / speed, 1, 0.01 * bounces) << "bounce " << bounces;
    EXPECT_NEAR(ball.t - gap / left, due, 0.01 * due) << "bounce " << bounces;
    due += 2 * speed / gravity;
  }
}

// The race is the rod, Hertz' 40 kHz its stiffness: T/4 = sqrt(L/g) K(sin(theta0/2)).
TEST_P(ClosedFormMotion, StiffPendulumKeepsItsPeriod) {
  const double gravity = 100, swing = 1.0;
  const Scene scene = lonely_scene(gravity);
  LonelyRollers pendulum(scene, GetParam(), kBottom + swing, 0);
  const double quarter =
      std::sqrt(pendulum.race() / gravity) * std::comp_ellint_1(std::sin(swing / 2));
  double before = 0, angle = swing;
  while (angle > 0) {
    const double last = angle;
    before = pendulum.t;
    ASSERT_TRUE(pendulum.step(0.1)) << pendulum.integrator->failure();
    angle = pendulum.get(kAngle) - kBottom;
    if (angle <= 0) {
      const double passed = before + (pendulum.t - before) * last / (last - angle);
      EXPECT_NEAR(passed / quarter, 1, 2e-4);
      // Energy, as speed at the lowest point: v^2 = 2 g L (1 - cos(theta0)).
      const double v = pendulum.get(kRadius) * pendulum.get(kOrbitRate);
      EXPECT_NEAR(v * v / (2 * gravity * pendulum.race() * (1 - std::cos(swing))), 1, 2e-3);
    }
  }
}

std::vector<IntegrationMethod> all_methods() {
  std::vector<IntegrationMethod> methods;
  for (const auto& [method, text] : spellings(IntegrationMethod{})) methods.push_back(method);
  return methods;
}

INSTANTIATE_TEST_SUITE_P(Methods, ClosedFormMotion, testing::ValuesIn(all_methods()),
                         [](const auto& test) {
                           std::string name = spelled(test.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace cagetol
