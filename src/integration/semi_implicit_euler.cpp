#include "src/integration/semi_implicit_euler.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {

StepStatus SemiImplicitEuler::step(System& system, double& t, double* y, double t_end) {
  if (system.counts.steps >= keys_.step_budget) return StepStatus::out_of_budget;
  const bool last = t + keys_.fixed_step >= t_end;
  const double h = last ? t_end - t : keys_.fixed_step;
  const StateLayout& l = system.model.layout;
  const int positions = l.positions();
  watch_error(system, h);
  for (int i = positions; i < system.size; ++i)
    y[i] += h * system.rate[static_cast<std::size_t>(i)];
  // Every position's rate is a velocity slot; the spin, last of the roller velocities, has no
  // position.
  const int roller = kRollerPositions * l.padded(), border = l.border();
  for (int i = 0; i < roller; ++i) y[i] += h * y[positions + i];
  for (int i = 0; i < border; ++i) y[l.border_position(i)] += h * y[l.border_velocity(i)];
  for (int i = 0; i < system.size; ++i)
    if (!std::isfinite(y[i])) {
      failure_ = "the state is no longer finite at t = " + std::to_string(t) + " s";
      return StepStatus::failed;
    }
  t = last ? t_end : t + h;
  ++system.counts.steps;
  system.counts.smallest_step = std::min(system.counts.smallest_step, h);
  return StepStatus::accepted;
}

void SemiImplicitEuler::watch_error(System& system, double h) {
  if (!past_rate_.empty()) {
    error_.assign(past_rate_.size(), 0.0);
    for (int i = system.model.layout.positions(); i < system.size; ++i) {
      const auto k = static_cast<std::size_t>(i);
      error_[k] = h / 2 * (system.rate[k] - past_rate_[k]);
    }
    system.counts.largest_step_error =
        std::max(system.counts.largest_step_error, error_norm(system, error_.data()));
  }
  past_rate_ = system.rate;
}

}  // namespace cagetol
