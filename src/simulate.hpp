// The entry point of the physics: a scene in, an outcome out. The same scene and the same build
// give the same bits.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "src/operation/operating_scene.hpp"
#include "src/quantities/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct System;
struct CageTable;
struct CageModel;

/// Optional inputs of a run.
struct SimulateOptions {
  /// Table of the flexible cage (src/cage/table/scene_cage.hpp), which the samples of a study
  /// share. If null, one is made from the pockets of the scene, which takes some seconds.
  std::shared_ptr<const CageTable> cage_table = {};
  /// The flexible cage of this very scene, where the caller has made it already.
  std::shared_ptr<const CageModel> cage_model = {};
  /// If not empty: why this sample's flexible cage has no table. The run fails with this reason.
  std::string why_no_cage = {};
  /// Called at every accepted state, after its linearisation (src/integration/system.hpp). For time
  /// histories and tests.
  std::function<void(double t, const double* y, const System& system)> on_state = {};
  /// Called every few hundred steps; true ends the run as not_run. For signals and wall-clock
  /// limits only.
  std::function<bool()> stop_requested = {};
};

/// Simulates one bearing. A jam or a failed integration is a status of the outcome, not an
/// exception.
Outcome simulate(const OperatingScene& scene, const SimulateOptions& options = {});

}  // namespace cagetol
