// The stability suite: scenes in which integration methods fail, each run by each method, judged by
// numbers. What must never happen is a wrong result that looks right.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "src/quantities/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

struct SuiteScene {
  std::string name;
  Scene scene;
  bool fast = false;
};

/// Reads a suite file (inputs/stability.toml says how it is written). Throws InputError.
std::vector<SuiteScene> read_suite(const std::string& path);

/// Of five starts, the cage a fifth of a pitch further on in each:
/// right:      every watch within its bound from every start, and the trajectory within 0.1 error
///             scales (0.1 um, 1 mm/s of an NU 205, root mean square; median of three instants,
///             then of the starts) of a tight run of a method of another kind; or the due jam
/// degraded:   the same, within 1 error scale
/// wrong:      further away though no watch speaks: a silently wrong result
/// unresolved: every watch within its bound, but two tight references part by more than 0.1 error
///             scales (or are missing): the trajectory decides nothing
/// failed:     a run from one of the starts says itself that it failed
enum class Soundness { right, degraded, wrong, unresolved, failed };
const char* soundness_name(Soundness soundness);

inline constexpr double kRightError = 0.1, kDegradedError = 1;  ///< [error scales]
inline constexpr double kSuiteHorizon = 0.5e-3;                 ///< of trajectories [s]
inline constexpr int kSuiteStarts = 5;

struct SuiteCell {
  Soundness soundness = Soundness::failed;
  double trajectory_error = 0;  ///< median of the starts [error scales]; NaN: none
  Outcome outcome;  ///< of the whole window, of the first start that failed or else of the first
};

struct SuiteRow {
  std::string scene;
  double reference_gap = 0;  ///< of the two references' trajectories, median; NaN: one is missing
  std::map<IntegrationMethod, SuiteCell> cells;  ///< by method
};

struct StabilityMap {
  IntegrationMethod default_method = IntegrationMethod::rodasp;
  std::vector<IntegrationMethod> methods;
  std::vector<SuiteRow> rows;
};

Soundness judge_soundness(Status status, double trajectory_error, double reference_gap);

/// Runs the suite, `threads` cells at a time; `on_row` sees each scene when it is done.
StabilityMap run_stability(const std::vector<SuiteScene>& suite,
                           const std::vector<IntegrationMethod>& methods, int threads,
                           const std::function<void(const SuiteRow&)>& on_row = {});

/// No method is silently wrong on any scene, and the default, if it was run, is right on all.
bool is_sound(const StabilityMap& map);

nlohmann::ordered_json stability_json(const StabilityMap& map);
std::string stability_text(const StabilityMap& map);

}  // namespace cagetol
