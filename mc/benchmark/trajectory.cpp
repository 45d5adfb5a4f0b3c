#include "mc/benchmark/trajectory.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/integration/system.hpp"

namespace cagetol {
namespace {

constexpr double kPadding = 1e20;  // scales beyond belong to slots that are no bodies

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
    if (t >= horizon && trajectory.state.empty()) trajectory.state.assign(y, y + system.size);
    if (!trajectory.scale.empty()) return;
    trajectory.scale.assign(system.scale.begin(), system.scale.end());
    began = Clock::now();
  };
  trajectory.outcome = simulate(brief, options);
  trajectory.motion_wall_s = std::chrono::duration<double>(Clock::now() - began).count();
  return trajectory;
}

double trajectory_error(const Trajectory& run, const Trajectory& reference) {
  if (run.state.empty() || reference.state.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  int components = 0;
  for (std::size_t i = 0; i < run.state.size(); ++i) {
    if (reference.scale[i] > kPadding) continue;
    const double e = (run.state[i] - reference.state[i]) / reference.scale[i];
    sum += e * e;
    ++components;
  }
  return std::sqrt(sum / components);
}

}  // namespace cagetol
