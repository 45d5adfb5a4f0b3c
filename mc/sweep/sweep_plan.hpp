// All that a sweep needs to know about its study: what a sample is and how one is run. Tests put an
// analytic job in here.
#pragma once

#include <cstdint>
#include <functional>

#include "mc/run/sample_run.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"

namespace cagetol {

/// Asked while a sample runs; true ends it as `not_run`.
using StopRequested = std::function<bool()>;

struct SweepPlan {
  Study study;
  std::uint64_t rows = 0;     ///< of the design
  std::uint64_t samples = 0;  ///< ids are 0 .. samples-1
  /// Makes what samples share and takes long, and keeps it where all ranks find it: each rank makes
  /// its part, before the first sample of any. May be empty.
  std::function<void(int rank, int ranks)> prepare;
  std::function<Sample(std::uint64_t id)> draw;
  std::function<Outcome(const Sample&, const StopRequested&)> job;
};

/// The plan of a real study: its sampler and the physics.
SweepPlan make_sweep_plan(const Study& study);

}  // namespace cagetol
