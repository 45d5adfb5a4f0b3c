// A study whose physics is a formula: for tests of everything around the physics. Draws and
// outcomes are pure functions of the id.
#pragma once

#include <optional>
#include <string>

#include "mc/sweep/sweep_plan.hpp"

namespace cagetol {

struct StandinOptions {
  long samples = 40;
  double radial_load = 1000;                   ///< a key of the stand-in scene, in N
  std::string file_hash = "0123456789abcdef";  ///< of a file that the study reads
  double mean_ms = 2;        ///< run time of a sample: uneven, between 0.1 and 4 times this
  double failure_share = 0;  ///< of samples that fail
  std::optional<long> abort_id = {};  ///< this sample aborts its process
  std::optional<long> exit_id = {};   ///< this sample ends its process with exit code 9
  std::optional<long> kill_id = {};   ///< this sample is killed, as by the guard of the memory
  std::optional<long> throw_id = {};  ///< this sample throws
  std::optional<long> late_id = {};   ///< this sample meets its wall-clock limit
};

/// Every fifth sample or so is jammed, `failure_share` of them fail; the others are ok.
SweepPlan make_standin_plan(const StandinOptions& options);

}  // namespace cagetol
