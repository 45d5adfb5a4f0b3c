// A sample simulated the way a sweep does it: its outcome and the history that its study asks for.
#pragma once

#include <functional>
#include <vector>

#include "mc/history_channels.hpp"
#include "mc/study.hpp"
#include "src/outcome.hpp"
#include "src/simulate.hpp"

namespace cagetol {

struct SampleRun {
  Outcome outcome;
  std::vector<double> history;  ///< SampleHistory::take(); empty where the study keeps none
};

/// `on_instant`, where given, sees every accepted state; `options.on_state` is not for callers.
SampleRun run_sample(const HistoryPlan& history, const Scene& scene, SimulateOptions options = {},
                     const std::function<void(const Instant&)>& on_instant = {});

}  // namespace cagetol
