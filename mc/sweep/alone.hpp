// A suspect sample runs alone, in a process of its own: should it kill that process, everything
// else goes on.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "mc/run/stored_outcome.hpp"

namespace cagetol {

struct AloneResult {
  /// The outcome; `poisoned` when the process died by the sample's own doing: a fault, an abort, an
  /// exit.
  std::optional<StoredOutcome> outcome;
  std::string
      why_not;  ///< without outcome: killed from outside, interrupted, or no process to be had
};

/// Calls `run` in a child process. To be called before MPI or threads start. `run` gives nothing
/// when it was interrupted.
AloneResult run_alone(std::uint64_t id, const std::function<std::optional<StoredOutcome>()>& run);

}  // namespace cagetol
