// The one door to the physics: a scene in, an outcome out. Deterministic: same scene, same build,
// same bits.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "src/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct System;
struct CageTable;
struct CageModel;

/// What a run may be given beside its scene.
struct SimulateOptions {
  /// Of the flexible cage (src/cage/scene_cage.hpp). Without one it is made from the scene's own
  /// pockets, which takes some seconds; samples of a study share the tables of the nominal scene.
  std::shared_ptr<const CageTable> cage_table = {};
  /// The flexible cage of this very scene, where the caller has made it already.
  std::shared_ptr<const CageModel> cage_model = {};
  /// Why there is no table for this sample's flexible cage: the run fails with this reason.
  std::string why_no_cage = {};
  /// Called at every accepted state, linearised (src/integration/system.hpp): time histories,
  /// tests.
  std::function<void(double t, const double* y, const System& system)> on_state = {};
  /// Called before on_state where the measuring window begins anew, because settling is extended.
  std::function<void(double begin)> on_window = {};
  /// Asked every few hundred steps; true ends the run as `not_run`. For signals and wall limits
  /// only.
  std::function<bool()> stop_requested = {};
};

/// Simulates one bearing. Never throws for what a sample may meet (jam, failed integration): that
/// is the outcome's status.
Outcome simulate(const Scene& scene, const SimulateOptions& options = {});

}  // namespace cagetol
