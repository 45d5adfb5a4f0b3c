// The stages of a recommendation as sweeps: DIR/pilot, DIR/mixture, DIR/confirm-1 ... each a
// directory like any other sweep's, so that it is resumed, replayed and reported as one.
#pragma once

#include <functional>
#include <string>

#include "mc/host/progress.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

struct RecommendOptions {
  std::string directory;
  ProgressStyle progress = ProgressStyle::automatic;
  bool exit_code = false;  ///< ends with 1 where no tolerance is confirmed
};

/// Every rank calls it; rank 0 alone reads the study and decides, and tells the others what to run.
/// Returns the exit code of the program on rank 0 and 0 elsewhere: 0 decided; 1 no tolerance
/// confirmed, where asked for; 2, 3, 70, 75 as of run_sweep. MPI has ended when it returns.
int run_recommend(const std::function<Study()>& read, const MakePlan& make_plan,
                  const RecommendOptions& options);

}  // namespace cagetol
