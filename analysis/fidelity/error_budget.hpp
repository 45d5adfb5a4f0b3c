// The error budget of a mean that a study reports: what it is off by, source by source.
//   statistical  standard error of the mean: other samples would move it by as much
//   noise        the part of it that fresh starts of the same cages make, s_w / sqrt(N);
//                s_w: standard deviation of one run about the mean of its cage, N: runs
//   integrator, modes, slices, mesh, window
//                what one setting of the model does: mean as run - mean with it refined, from pairs
//                of runs of the same samples, with Student's t interval
// An error of a setting counts as resolved where it stays significant at 1 - confidence with all
// settings of the quantity tested together (Holm): else the largest of five zeros would be named
// once in five quantities. What one refinement does not reach is in no budget, and errors of
// settings need not add up.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/estimate.hpp"

namespace cagetol {

/// Settings whose errors a refining ladder measures, in the order of the report.
inline constexpr std::array<std::string_view, 5> kRefinedSettings = {"integrator", "modes",
                                                                     "slices", "mesh", "window"};

/// resolved: known to differ from zero; unresolved: |error| is below `bound`, its sign is not
/// known; lost: too many refined runs gave no value; not_measured: nobody looked.
enum class ErrorState { resolved, unresolved, lost, not_measured };
const char* error_state_name(ErrorState state);

struct ErrorSource {
  std::string name;
  ErrorState state = ErrorState::not_measured;
  /// In the quantity's unit. Of a setting positive where the study's mean is too large; statistical
  /// and noise have no sign.
  Estimate error = {};
  /// Largest |error| at the confidence of the budget: the far end of the interval of a setting's
  /// error, the normal quantile times a standard error.
  double bound = kUndefined;
  /// |error| as a share of the standard error of the mean; of an unresolved one, that of its bound.
  double share = kUndefined;
  std::size_t pairs = 0;  ///< samples with a value on both sides
  std::size_t lost = 0;   ///< samples with a value only as run
};

/// How sure the study is of the mean that it reports.
struct ReportedMean {
  double standard_error = kUndefined;   ///< NaN: the design does not tell
  std::size_t runs = 0;                 ///< N
  double noise_deviation = kUndefined;  ///< s_w; NaN: too few rows were run again
  Estimate noise_share = {};            ///< s_w^2 / variance of all runs, with its interval
};

/// What refining a setting does to the mean: refined minus as run.
struct RefinedShift {
  std::string setting;
  Estimate shift = {};
  std::size_t pairs = 0, lost = 0;
  bool usable = true;  ///< false: lost more samples than a ladder allows
};

struct ErrorBudget {
  std::vector<ErrorSource> sources;  ///< statistical, noise, then kRefinedSettings
  /// The source with the largest bound among the resolved ones, noise being part of statistical;
  /// empty where none is, or none has an error.
  std::string largest = {};
  std::vector<std::string> open = {};  ///< unresolved ones that may be larger than `largest`
};

/// Shifts of settings that are not there are not measured. `confidence` is that of the shifts'
/// intervals.
ErrorBudget error_budget(const ReportedMean& mean, std::span<const RefinedShift> shifts,
                         double confidence);

}  // namespace cagetol
