// Observed order of the Rosenbrock methods on a smooth stretch: loaded rolling without touches,
// against classical Runge-Kutta steps written here. Halving the step divides the error by 2^order.
#include <gtest/gtest.h>
#include <cmath>
#include <vector>

#include "src/integration/integrator.hpp"
#include "src/statics/start_state.hpp"

namespace cagetol {
namespace {

constexpr double kEnd = 100e-6;

Scene smooth_scene() {
  Scene scene;
  scene.operation.gravity = 0;
  scene.discretisation.race_slices = 1;
  return scene;
}

/// A start that is off balance by little: the ring rings, the rollers creep, nothing opens or
/// closes.
std::vector<double> smooth_start(const BearingModel& model, const Scene& scene) {
  std::vector<double> y = start_state(model, scene.start);
  const StateLayout& l = model.layout;
  y[static_cast<std::size_t>(l.border_velocity(kRingZ))] = 2e-3;
  y[static_cast<std::size_t>(l.border_velocity(kRingY))] = 1e-3;
  for (int j = 0; j < l.rollers; ++j) y[static_cast<std::size_t>(l.velocity(kSpin, j))] *= 1 + 1e-3;
  return y;
}

std::vector<double> runge_kutta(const BearingModel& model, std::vector<double> y, double h) {
  const std::size_t n = y.size();
  std::vector<double> k1(n), k2(n), k3(n), k4(n), at(n);
  const long steps = std::lround(kEnd / h);
  const auto move = [&](const std::vector<double>& k, double by) {
    for (std::size_t i = 0; i < n; ++i) at[i] = y[i] + by * k[i];
  };
  for (long s = 0; s < steps; ++s) {
    const double t = static_cast<double>(s) * h;
    evaluate_rates(model, t, y.data(), k1.data());
    move(k1, h / 2);
    evaluate_rates(model, t + h / 2, at.data(), k2.data());
    move(k2, h / 2);
    evaluate_rates(model, t + h / 2, at.data(), k3.data());
    move(k3, h);
    evaluate_rates(model, t + h, at.data(), k4.data());
    for (std::size_t i = 0; i < n; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

std::vector<double> fixed_steps(const BearingModel& model, std::vector<double> y,
                                IntegrationMethod method, double h) {
  Integration keys;
  keys.method = method;
  keys.tolerance = 1e12;  // every step is good enough: max_step fixes it after a few short ones
  keys.max_step = h;
  System system(model);
  double t = 0;
  const auto integrator = make_integrator(keys, system, t, y.data());
  while (t < kEnd) {
    EXPECT_TRUE(system.linearise_at(t, y.data()));
    if (integrator->step(system, t, y.data(), kEnd) != StepStatus::accepted) {
      ADD_FAILURE() << integrator->failure();
      break;
    }
  }
  return y;
}

double apart(const System& system, const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] - b[i];
  return error_norm(system, difference.data());
}

struct Order {
  IntegrationMethod method;
  bool driven;  ///< by speeds and a load on straight lines over time
  double order;
  double coarse;  ///< largest step [s]
};

class ObservedOrder : public testing::TestWithParam<Order> {};

TEST_P(ObservedOrder, IsTheMethodsOwn) {
  Scene scene = smooth_scene();
  if (GetParam().driven) {
    const double w = scene.operation.inner_speed;
    scene.operation.table.time = {{0, 2 * kEnd}};
    scene.operation.table.inner_speed = {{w, 1.03 * w}};
    scene.operation.table.radial_load = {{1000, 1400}};
    scene.operation.table.direction = {{0, 0.1}};
  }
  const BearingModel model = make_bearing_model(scene);
  const System system(model);
  const std::vector<double> start = smooth_start(model, scene);
  const std::vector<double> exact = runge_kutta(model, start, 0.05e-6);
  ASSERT_LT(apart(system, exact, runge_kutta(model, start, 0.1e-6)), 1e-8);  // the reference is one
  std::vector<double> errors;
  for (int halving = 0; halving < 4; ++halving)
    errors.push_back(
        apart(system, exact,
              fixed_steps(model, start, GetParam().method, GetParam().coarse / (1 << halving))));
  for (std::size_t k = 1; k < errors.size(); ++k) {
    const double order = std::log2(errors[k - 1] / errors[k]);
    RecordProperty("order_" + std::to_string(k), std::to_string(order));
  }
  const double last = std::log2(errors[errors.size() - 2] / errors.back());
  EXPECT_NEAR(last, GetParam().order, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Rosenbrock, ObservedOrder,
                         testing::Values(Order{IntegrationMethod::rodas3, false, 3, 2e-6},
                                         Order{IntegrationMethod::rodasp, false, 4, 8e-6},
                                         Order{IntegrationMethod::rodas3, true, 3, 2e-6},
                                         Order{IntegrationMethod::rodasp, true, 4, 8e-6}),
                         [](const auto& test) {
                           return std::string(spelled(test.param.method)) +
                                  (test.param.driven ? "_driven" : "");
                         });

}  // namespace
}  // namespace cagetol
