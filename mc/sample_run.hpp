// A sample simulated the way a sweep does it: its outcome and the history that its study asks for.
#pragma once

#include <functional>
#include <vector>

#include "mc/history_channels.hpp"
#include "mc/sample.hpp"
#include "src/outcome.hpp"

namespace cagetol {

/// Asked while a sample runs; true ends it as `not_run`.
using StopRequested = std::function<bool()>;

struct SampleRun {
  Outcome outcome;
  std::vector<double> history;  ///< SampleHistory::take(); empty where the study keeps none
};

/// `on_instant`, where given, sees every accepted state.
SampleRun run_sample(const HistoryPlan& history, const Scene& scene,
                     const StopRequested& stop_requested,
                     const std::function<void(const Instant&)>& on_instant = {});

}  // namespace cagetol
