// What one quantity does over the runs: mean, scatter, quantiles, each with its interval.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/resampling.hpp"

namespace cagetol {

/// Levels of the quantiles in every table.
inline constexpr double kQuantileLevels[] = {0.01, 0.05, 0.25, 0.50, 0.75, 0.95, 0.99};

struct Summary {
  std::size_t defined = 0;  ///< runs in which the quantity has a value
  double smallest = kUndefined, largest = kUndefined;
  Estimate mean, standard_deviation;
  double standard_error = kUndefined;  ///< of the mean
  std::vector<Estimate> quantiles;     ///< at kQuantileLevels
  double bound_95 = kUndefined;  ///< exceeds the 95 % quantile with the confidence given, whatever
                                 ///< the law (Wilks)
  std::string bound_95_refused;  ///< why there is no such bound
};

double weighted_mean(std::span<const double> values, std::span<const double> weights);

/// Unbiased for equal weights. NaN values are left out of both.
double weighted_standard_deviation(std::span<const double> values, std::span<const double> weights);

/// Over the runs with a value. `weights` as of the tolerance studied (empty: equal).
Summary summarise(const StudyData& runs, std::span<const double> values,
                  const Resampling& resampling, double confidence,
                  std::span<const double> weights = {});

/// The smallest run that is an upper bound of the 95 % quantile. Throws Refused for dependent runs,
/// or when there are too few.
double wilks_bound(const StudyData& runs, std::span<const double> values, double coverage,
                   double confidence);

}  // namespace cagetol
