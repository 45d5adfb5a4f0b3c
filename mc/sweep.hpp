// Runs every sample of a study once, on one process or under mpirun, and goes on where an earlier
// start ended.
#pragma once

#include <functional>
#include <string>

#include "mc/progress.hpp"
#include "mc/sweep_plan.hpp"

namespace cagetol {

struct SweepOptions {
  std::string directory;
  ProgressStyle progress = ProgressStyle::automatic;
  double rebuild_interval_s = 180;  ///< how often study.h5 is brought up to date on the way
};

/// `make_plan` reads the study; every rank calls it. Returns the exit code of the program on rank
/// 0, and 0 on other ranks: 0 done, 2 bad input or unusable directory, 3 more samples failed than
/// the study allows, 75 interrupted: start again to go on. Problems are printed by one rank only.
/// May end the process itself with 75 when a signal leaves no time for an orderly end.
int run_sweep(const std::function<SweepPlan()>& make_plan, const SweepOptions& options);

}  // namespace cagetol
