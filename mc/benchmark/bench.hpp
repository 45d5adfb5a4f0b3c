// What a bearing costs to simulate, by integration method: `simulate` itself is timed, all watches
// on.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "src/quantities/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct BenchOptions {
  std::vector<IntegrationMethod> methods;  ///< empty: all; the scene's own always runs
  int repeats = 3;
};

/// Microseconds of one evaluation, mean of instants in the later half of the scene's run.
struct KernelTimes {
  double rhs_us = 0;             ///< all forces
  double linearise_us = 0;       ///< all forces, their derivatives, the observation
  double free_rhs_us = 0;        ///< as rhs_us, with pockets too large to be touched
  double free_linearise_us = 0;  ///< as linearise_us, likewise
  double factorise_us = 0;       ///< of the Newton matrix
  double solve_us = 0;           ///< with the factors
  double record_us = 0;          ///< what a measured state adds to quantities, stress and fatigue
};

/// One method. RTF: wall seconds per simulated second.
struct MethodCost {
  IntegrationMethod method = IntegrationMethod::rodasp;
  Status status = Status::not_run;
  std::string reason;          ///< why it is not ok
  double rtf = 0;              ///< median of the repeats; NaN where the method is not ok
  double against_default = 0;  ///< median of RTF over the default's in the same repeat; likewise
  std::vector<double> rtf_runs;
  RunRecord run;  ///< of the last repeat
};

struct BenchResult {
  std::string scene;
  KernelTimes kernels;
  double start_s = 0;  ///< of a run before its first step: elastic cage, model, statics
  std::vector<MethodCost> methods;  ///< the scene's own first
};

/// A part of a cost, and its share of the whole.
struct CostPart {
  std::string name;
  double share = 0;
};

/// Where the wall time of the scene's own method goes: kernels by their counts, pockets by what
/// the kernels cost without them, the rest last.
std::vector<CostPart> run_parts(const BenchResult& result);

/// Runs the methods in turn, `repeats` times, so that the noise of a shared machine meets all of
/// them alike.
BenchResult bench(const Scene& scene, const BenchOptions& options);

nlohmann::ordered_json bench_json(const BenchResult& result);
std::string bench_text(const BenchResult& result);

}  // namespace cagetol
