// Runs every sample of a study once, on one process or under mpirun, and goes on where an earlier
// start ended.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "mc/host/build_info.hpp"
#include "mc/host/progress.hpp"
#include "mc/ranks/team.hpp"
#include "mc/sweep/agreement.hpp"
#include "mc/sweep/journal.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "mc/sweep/sweep_plan.hpp"

namespace cagetol {

struct SweepOptions {
  std::string directory;
  ProgressStyle progress = ProgressStyle::automatic;
  double rebuild_interval_s = 180;  ///< how often study.h5 is brought up to date on the way
  /// The sweep ends where more of its first samples miss a limit, or have no result; rank 0's.
  std::optional<std::uint64_t> allowed_misses = {};
};

/// `make_plan` reads the study; every rank calls it. Returns the exit code of the program on rank
/// 0, and 0 on other ranks: 0 done, 2 bad input or unusable directory, 3 more samples failed than
/// the study allows, 70 a fault of the program, 75 interrupted: start again to go on. Problems are
/// printed by one rank only. May end the process itself with 75 when a signal leaves no time for an
/// orderly end.
int run_sweep(const std::function<SweepPlan()>& make_plan, const SweepOptions& options);

/// One sweep in two steps, for programs that run several below one MPI; run_sweep does both. A
/// SignalWatch must live around it.
class Sweep {
 public:
  Sweep(const Launch& launch, const SweepOptions& options) : launch_(launch), options_(options) {}

  /// Reads the study and, on rank 0, opens the directory. Samples that were lost again and again
  /// run alone here, which needs a process without MPI: with `mpi_runs` they stay open. Problems
  /// are kept for run().
  void prepare(const std::function<SweepPlan()>& make_plan, bool mpi_runs);
  /// Every rank calls it. Returns and ends as run_sweep does.
  int run(const Team& team);

 private:
  void open_journal();

  Launch launch_;
  SweepOptions options_;
  BuildInfo build_ = build_info();
  SweepPlan plan_;
  std::unique_ptr<SweepDirectory> directory_;
  std::unique_ptr<Journal> journal_;
  Problem problem_;
};

}  // namespace cagetol
