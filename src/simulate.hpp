// The one door to the physics: a scene in, an outcome out. Deterministic: same scene, same build,
// same bits.
#pragma once

#include <functional>
#include <string>

#include "src/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct System;

/// Extras of a run that do not change its outcome.
struct SimulateOptions {
  /// Called at every accepted state, linearised (src/integration/system.hpp): time histories,
  /// tests.
  std::function<void(double t, const double* y, const System& system)> on_state;
  /// Asked every few hundred steps; true ends the run as `not_run`. For signals and wall limits
  /// only.
  std::function<bool()> stop_requested;
};

/// Simulates one bearing. Never throws for what a sample may meet (jam, failed integration): that
/// is the outcome's status.
Outcome simulate(const Scene& scene, const SimulateOptions& options = {});

}  // namespace cagetol
