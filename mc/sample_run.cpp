#include "mc/sample_run.hpp"

#include <optional>

#include "mc/sample_history.hpp"

namespace cagetol {

SampleRun run_sample(const HistoryPlan& plan, const Scene& scene, SimulateOptions options,
                     const std::function<void(const Instant&)>& on_instant) {
  std::optional<SampleHistory> history;
  if (plan.points > 0) history.emplace(plan, scene);
  std::optional<CageStress> stress;
  if (history || on_instant)
    options.on_state = [&](double t, const double* y, const System& system) {
      const auto& cage = system.model.flexible.model;
      if (cage && !stress) stress.emplace(*cage);
      const Instant at{t, y, system, stress ? &*stress : nullptr};
      if (history) history->record(at);
      if (on_instant) on_instant(at);
    };
  SampleRun run{simulate(scene, options), {}};
  if (history) run.history = history->take();
  return run;
}

}  // namespace cagetol
