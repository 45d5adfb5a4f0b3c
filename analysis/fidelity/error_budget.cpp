#include "analysis/fidelity/error_budget.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "analysis/compare/holm.hpp"

namespace cagetol {
namespace {

double normal_quantile(double confidence) {
  return gsl_cdf_ugaussian_Pinv(0.5 * (1 + confidence));
}

ErrorSource statistical_error(const ReportedMean& mean, double confidence) {
  ErrorSource source{.name = "statistical"};
  if (std::isnan(mean.standard_error)) return source;
  source.state = ErrorState::resolved;
  source.error.value = mean.standard_error;
  source.bound = normal_quantile(confidence) * mean.standard_error;
  if (mean.standard_error > 0) source.share = 1;
  return source;
}

ErrorSource noise_error(const ReportedMean& mean, double confidence) {
  ErrorSource source{.name = "noise"};
  const Estimate& share = mean.noise_share;
  const double error = mean.noise_deviation / std::sqrt(static_cast<double>(mean.runs));
  if (!std::isfinite(error)) return source;
  source.state = ErrorState::resolved;
  source.error.value = error;
  if (share.value > 0) {
    source.error.lower = error * std::sqrt(std::max(share.lower, 0.0) / share.value);
    source.error.upper = error * std::sqrt(share.upper / share.value);
  }
  source.share = error / mean.standard_error;
  source.bound = normal_quantile(confidence) * error;
  return source;
}

double half_width(const Estimate& shift) {
  return 0.5 * (shift.upper - shift.lower);
}

/// That the shift is zero, by Student's t.
double p_value(const RefinedShift& refined, double confidence) {
  const double size = std::abs(refined.shift.value), half = half_width(refined.shift);
  if (!(half > 0)) return size > 0 ? 0 : 1;
  const auto freedom = static_cast<double>(refined.pairs) - 1;
  const double quantile = gsl_cdf_tdist_Pinv(0.5 * (1 + confidence), freedom);
  return 2 * gsl_cdf_tdist_Q(quantile * size / half, freedom);
}

bool has_interval(const RefinedShift& refined) {
  return refined.usable && refined.pairs >= 2 && std::isfinite(half_width(refined.shift));
}

ErrorSource setting_error(const RefinedShift& refined, bool resolved, double standard_error) {
  ErrorSource source{.name = refined.setting};
  source.pairs = refined.pairs;
  source.lost = refined.lost;
  if (!refined.usable) {
    source.state = ErrorState::lost;
    return source;
  }
  if (!has_interval(refined)) return source;
  const Estimate& shift = refined.shift;
  source.state = resolved ? ErrorState::resolved : ErrorState::unresolved;
  source.error = {0 - shift.value, 0 - shift.upper, 0 - shift.lower};
  source.bound = std::abs(shift.value) + half_width(shift);
  source.share = (resolved ? std::abs(shift.value) : source.bound) / standard_error;
  return source;
}

/// Names the largest source and those that may be larger.
void compare_sources(ErrorBudget& budget) {
  double largest = 0;
  for (const ErrorSource& source : budget.sources)
    if (source.state == ErrorState::resolved && source.name != "noise" && source.bound > largest) {
      largest = source.bound;
      budget.largest = source.name;
    }
  for (const ErrorSource& source : budget.sources)
    if (source.state == ErrorState::unresolved && source.bound > largest)
      budget.open.push_back(source.name);
}

}  // namespace

const char* error_state_name(ErrorState state) {
  constexpr const char* kNames[] = {"resolved", "unresolved", "runs lost", "not measured"};
  return kNames[static_cast<int>(state)];
}

ErrorBudget error_budget(const ReportedMean& mean, std::span<const RefinedShift> shifts,
                         double confidence) {
  std::vector<RefinedShift> settings;
  for (const std::string_view name : kRefinedSettings) {
    const auto found = std::find_if(shifts.begin(), shifts.end(),
                                    [&](const RefinedShift& s) { return s.setting == name; });
    settings.push_back(found != shifts.end() ? *found : RefinedShift{.setting = std::string(name)});
  }
  std::vector<double> p_values;
  for (const RefinedShift& setting : settings)
    if (has_interval(setting)) p_values.push_back(p_value(setting, confidence));
  const auto adjusted = holm_adjusted(p_values);
  ErrorBudget budget{
      .sources = {statistical_error(mean, confidence), noise_error(mean, confidence)}};
  std::size_t tested = 0;
  for (const RefinedShift& setting : settings) {
    const bool resolved = has_interval(setting) && adjusted[tested++] <= 1 - confidence;
    budget.sources.push_back(setting_error(setting, resolved, mean.standard_error));
  }
  compare_sources(budget);
  return budget;
}

}  // namespace cagetol
