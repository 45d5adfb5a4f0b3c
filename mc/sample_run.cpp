#include "mc/sample_run.hpp"

#include <optional>

#include "mc/sample_history.hpp"
#include "src/simulate.hpp"

namespace cagetol {

SampleRun run_sample(const HistoryPlan& plan, const Scene& scene,
                     const StopRequested& stop_requested,
                     const std::function<void(const Instant&)>& on_instant) {
  std::optional<SampleHistory> history;
  if (plan.points > 0) history.emplace(plan, scene);
  SimulateOptions options;
  options.stop_requested = stop_requested;
  if (history || on_instant)
    options.on_state = [&](double t, const double* y, const System& system) {
      const Instant at{t, y, system};
      if (history) history->record(at);
      if (on_instant) on_instant(at);
    };
  SampleRun run{simulate(scene, options), {}};
  if (history) run.history = history->take();
  return run;
}

}  // namespace cagetol
