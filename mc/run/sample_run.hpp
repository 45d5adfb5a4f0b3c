// A sample simulated the way a sweep does it.
#pragma once

#include <functional>

#include "mc/run/history_channels.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"
#include "src/quantities/outcome.hpp"
#include "src/simulate.hpp"

namespace cagetol {

/// Simulates a sample, at each operating point of the study in turn where it has several. The cage
/// of some samples, chosen by study.seed and their id, is also solved in full
/// (Study::cage_check_share). `on_instant`, where given, sees every accepted state;
/// `options.on_state` is not for callers. A flexible cage needs `options.cage_table` of study.scene
/// (mc/run/cage_cache.hpp).
Outcome run_sample(const Study& study, const Sample& sample, SimulateOptions options = {},
                   const std::function<void(const Instant&)>& on_instant = {});

}  // namespace cagetol
