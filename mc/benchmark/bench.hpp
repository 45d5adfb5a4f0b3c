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

/// Microseconds of one evaluation at the last state of the scene's run.
struct KernelTimes {
  double rhs_us = 0;        ///< all forces
  double linearise_us = 0;  ///< all forces, their derivatives, the observation
  double factorise_us = 0;  ///< of the Newton matrix
  double solve_us = 0;      ///< with the factors
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
  std::vector<MethodCost> methods;  ///< the scene's own first
};

/// A part of a cost, and its share of the whole.
struct CostPart {
  std::string name;
  double share = 0;
};

/// Where the wall time of the scene's own method goes: kernels by their counts, the rest last.
std::vector<CostPart> run_parts(const BenchResult& result);

/// Runs the methods in turn, `repeats` times, so that the noise of a shared machine meets all of
/// them alike.
BenchResult bench(const Scene& scene, const BenchOptions& options);

nlohmann::ordered_json bench_json(const BenchResult& result);
std::string bench_text(const BenchResult& result);

}  // namespace cagetol
