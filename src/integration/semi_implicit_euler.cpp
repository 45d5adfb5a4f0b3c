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

}  // namespace cagetol
