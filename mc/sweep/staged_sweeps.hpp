// Several sweeps one after another below one MPI, each in a directory of its own: rank 0 decides
// what runs next, the other ranks follow.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "mc/host/progress.hpp"
#include "mc/ranks/team.hpp"
#include "mc/sweep/sweep_plan.hpp"

namespace cagetol {

using MakePlan = std::function<SweepPlan(const Study&)>;

/// Rank 0's hold on the team while it leads.
class StagedSweeps {
 public:
  StagedSweeps(const Launch& launch, const MakePlan& make_plan, ProgressStyle progress)
      : launch_(launch), make_plan_(make_plan), progress_(progress) {}

  int ranks() const { return launch_.size; }
  /// Runs what is missing of the study in the directory. Exit code of run_sweep: 0 when every
  /// sample is stored, or those up to where more than `allowed_misses` miss a limit. Samples lost
  /// twice run alone only in the first sweep that has anything to run, because MPI has not begun
  /// then.
  int sweep(const Study& study, const std::string& directory,
            std::optional<std::uint64_t> allowed_misses = {});
  /// Nothing more to run: tells every rank to end. The exit code where ranks run different
  /// programs.
  int end();

 private:
  /// Meets the other ranks, once; the exit code where they run another program.
  int join();

  Launch launch_;
  const MakePlan& make_plan_;
  ProgressStyle progress_;
  std::unique_ptr<Team> team_;  ///< made with the first sweep that has anything to run
  int refused_ = 0;             ///< the exit code with which all ranks have parted
};

/// Every rank calls it; rank 0 alone calls `lead`, whose exit code it returns; the others return 0.
/// Problems of the user and of writing are printed and become exit codes. MPI has ended when it
/// returns.
int run_staged(const MakePlan& make_plan, ProgressStyle progress,
               const std::function<int(StagedSweeps&)>& lead);

}  // namespace cagetol
