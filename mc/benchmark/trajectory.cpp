#include "mc/benchmark/trajectory.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/integration/system.hpp"

namespace cagetol {
namespace {

constexpr double kPadding = 1e20;  // scales beyond belong to slots that are no bodies

double apart(const std::vector<double>& a, const std::vector<double>& b,
             const std::vector<double>& scale) {
  if (a.empty() || b.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  int components = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (scale[i] > kPadding) continue;
    const double e = (a[i] - b[i]) / scale[i];
    sum += e * e;
    ++components;
  }
  return std::sqrt(sum / components);
}

}  // namespace

std::vector<Scene> starts_of(const Scene& scene, int count) {
  std::vector<Scene> starts(static_cast<std::size_t>(count), scene);
  const double pitch = 2 * std::numbers::pi / static_cast<double>(scene.bearing.roller_count);
  for (int k = 0; k < count; ++k)
    starts[static_cast<std::size_t>(k)].start.cage_phase += pitch * k / count;
  return starts;
}

Trajectory follow(const Scene& scene, double horizon, SimulateOptions options) {
  Scene brief = scene;
  brief.window = {};
  brief.window.settle_time = brief.window.measure_time = horizon / 2;
  Watch& watch = brief.watch;
  watch.static_consistency_max = watch.energy_residual_max = watch.cage_drift_max =
      watch.power_surplus_max = std::numeric_limits<double>::infinity();  // nothing has settled yet
  using Clock = std::chrono::steady_clock;
  Clock::time_point began = Clock::now();
  Trajectory trajectory;
  options.on_state = [&](double t, const double* y, const System& system) {
    for (std::size_t k = 0; k < 2; ++k)
      if (t >= (k == 0 ? horizon / 2 : horizon) && trajectory.states[k].empty())
        trajectory.states[k].assign(y, y + system.size);
    if (!trajectory.scale.empty()) return;
    trajectory.scale.assign(system.scale.begin(), system.scale.end());
    began = Clock::now();
  };
  trajectory.outcome = simulate(brief, options);
  trajectory.motion_wall_s = std::chrono::duration<double>(Clock::now() - began).count();
  return trajectory;
}

std::array<double, 2> trajectory_error(const Trajectory& run, const Trajectory& reference) {
  return {apart(run.states[0], reference.states[0], reference.scale),
          apart(run.states[1], reference.states[1], reference.scale)};
}

}  // namespace cagetol
