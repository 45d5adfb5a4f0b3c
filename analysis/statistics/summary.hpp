// Summary of one quantity over the runs: mean, standard deviation and quantiles with their
// intervals.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/resampling.hpp"

namespace cagetol {

/// Levels of the quantiles in all tables.
inline constexpr double kQuantileLevels[] = {0.01, 0.05, 0.25, 0.50, 0.75, 0.95, 0.99};

struct Summary {
  std::size_t defined = 0;  ///< runs with a value of the quantity
  double smallest = kUndefined, largest = kUndefined;
  Estimate mean, standard_deviation;
  double standard_error = kUndefined;  ///< of the mean
  std::vector<Estimate> quantiles;     ///< at kQuantileLevels
  double bound_95 = kUndefined;        ///< upper bound of the 95 % quantile for any law (Wilks)
  std::string bound_95_refused;        ///< why there is no such bound
};

double weighted_mean(std::span<const double> values, std::span<const double> weights);

/// Weighted mean and standard deviation without NaN values. Unbiased for equal weights.
double weighted_standard_deviation(std::span<const double> values, std::span<const double> weights);

/// Quantile at p with its interval.
Estimate quantile_estimate(std::span<const double> values, std::span<const std::size_t> order,
                           double p, const Resampling& resampling, double confidence,
                           std::span<const double> weights = {});

/// Summary over the runs with a value. `weights`: those of the tolerance studied; empty: equal.
Summary summarise(const StudyData& runs, std::span<const double> values,
                  const Resampling& resampling, double confidence,
                  std::span<const double> weights = {});

/// The smallest run that is an upper bound of the 95 % quantile. Throws Refused for dependent runs
/// or too few runs.
double wilks_bound(const StudyData& runs, std::span<const double> values, double coverage,
                   double confidence);

}  // namespace cagetol
