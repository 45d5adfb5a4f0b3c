// The error budget of a mean in a study: its errors by source.
//
//   statistical  standard error of the mean
//   noise        the part of it due to the random start of a run, s_w / sqrt(N);
//                s_w: standard deviation of runs of the same cage, N: runs
//   integrator, modes, slices, mesh, window
//                error of one setting of the model: mean as run - mean with the setting refined,
//                from pairs of runs of the same samples, with Student's t interval
//
// The error of a setting is resolved if it is significant at 1 - confidence with all settings of
// the quantity tested together (Holm). Without Holm, one of five settings without any error would
// be reported for one in five quantities. Errors that remain after the refinement are not in the
// budget. The errors of the settings need not add up.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/study/estimate.hpp"

namespace cagetol {

/// Settings whose errors a refining ladder measures, in the order of the report.
inline constexpr std::array<std::string_view, 5> kRefinedSettings = {"integrator", "modes",
                                                                     "slices", "mesh", "window"};

/// resolved: differs from zero; unresolved: |error| is below `bound`, its sign is unknown; lost:
/// too many refined runs have no value; not_measured: there are no refined runs.
enum class ErrorState { resolved, unresolved, lost, not_measured };
const char* error_state_name(ErrorState state);

struct ErrorSource {
  std::string name;
  ErrorState state = ErrorState::not_measured;
  /// Error in the quantity's unit. For a setting, positive if the study's mean is too large.
  /// Statistical error and noise have no sign.
  Estimate error = {};
  /// Largest |error| at the confidence of the budget. Setting: the far end of its interval.
  /// Statistical error and noise: the normal quantile times the standard error.
  double bound = kUndefined;
  /// |error| over the standard error of the mean; if unresolved, `bound` over it.
  double share = kUndefined;
  std::size_t pairs = 0;  ///< samples with both values
  std::size_t lost = 0;   ///< samples without a refined value
};

/// Statistical uncertainty of a mean of the study.
struct ReportedMean {
  double standard_error = kUndefined;   ///< NaN: the design does not determine it
  std::size_t runs = 0;                 ///< N
  double noise_deviation = kUndefined;  ///< s_w; NaN: too few repeated rows
  Estimate noise_share = {};            ///< s_w^2 / variance of all runs, with its interval
};

/// Effect of refining a setting on the mean: refined minus as run.
struct RefinedShift {
  std::string setting;
  Estimate shift = {};
  std::size_t pairs = 0, lost = 0;
  bool usable = true;  ///< false: more samples lost than a ladder allows
};

struct ErrorBudget {
  std::vector<ErrorSource> sources;  ///< statistical, noise, then kRefinedSettings
  /// The source with the largest bound among the resolved ones, noise being part of statistical;
  /// empty where none is, or none has an error.
  std::string largest = {};
  std::vector<std::string> open = {};  ///< unresolved ones that may be larger than `largest`
};

/// The budget. Settings without a shift are not_measured. `confidence` is that of the intervals of
/// the shifts.
ErrorBudget error_budget(const ReportedMean& mean, std::span<const RefinedShift> shifts,
                         double confidence);

}  // namespace cagetol
