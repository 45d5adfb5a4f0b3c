// The rms of the pocket force over the steps of a run is that of the force between them as well.
#include <gtest/gtest.h>
#include <cmath>

#include "src/integration/system.hpp"
#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// Mean square of the force of a roller on its bars [N^2].
double mean_square(const System& system) {
  const int rollers = system.model.layout.rollers;
  double sum = 0;
  for (int j = 0; j < rollers; ++j) {
    const auto k = static_cast<std::size_t>(j);
    sum += std::pow(system.seen.leading_force[k] + system.seen.trailing_force[k], 2);
  }
  return sum / rollers;
}

// Between states the motion is Hermite's cubic; Simpson's rule over eight parts of each step.
TEST(PocketForceRms, IsThatOfEightPartsOfEveryStep) {
  Scene scene = shipped_scene("nu205");
  scene.integration.method = IntegrationMethod::rodas3;
  scene.integration.tolerance = 0.015;  // that of inputs/studies/nu205-rated.toml
  const BearingModel model = make_bearing_model(scene);
  const double settle = window_times(scene, model).settle;
  System between(model);
  std::vector<double> y0, rate0;
  double t0 = -1, first = 0, integral = 0, time = 0;
  const Outcome outcome =
      simulate(scene, {.on_state = [&](double t, const double* y, const System& system) {
                 if (t < settle) return;
                 const double last = mean_square(system);
                 if (t0 >= 0) {
                   constexpr int kParts = 8;
                   const double h = t - t0;
                   double sum = first + last;
                   PackVector at(static_cast<std::size_t>(system.size));
                   for (int i = 1; i < kParts; ++i) {
                     const double x = static_cast<double>(i) / kParts, left = 1 - x;
                     for (std::size_t k = 0; k < at.size(); ++k)
                       at[k] = left * left * ((1 + 2 * x) * y0[k] + x * h * rate0[k]) +
                               x * x * ((3 - 2 * x) * y[k] - left * h * system.rate[k]);
                     ASSERT_TRUE(between.linearise_at(t0 + x * h, at.data()));
                     sum += (i % 2 ? 4 : 2) * mean_square(between);
                   }
                   integral += h * sum / (3 * kParts);
                   time += h;
                 }
                 t0 = t, first = last;
                 y0.assign(y, y + system.size);
                 rate0.assign(system.rate.begin(), system.rate.end());
               }});
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  const double rms = std::sqrt(integral / time);
  EXPECT_NEAR(quantity(outcome, "pocket_force_rms_N"), rms, 5e-4 * rms);
}

}  // namespace
}  // namespace cagetol
