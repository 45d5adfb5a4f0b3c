// Quantiles, and bounds on them that hold for any law (Wilks 1941, doi:10.1214/aoms/1177731788).
//
// The r-th largest of n independent runs exceeds the quantile of level `coverage` with probability
//   1 - sum_{k=0}^{r-1} C(n,k) (1-coverage)^k coverage^(n-k)
// It is an upper bound of the quantile if this probability is at least the required confidence.
// Valid for independent runs only.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cagetol {

/// Indices of `values` in ascending order, without NaN.
std::vector<std::size_t> ascending_order(std::span<const double> values);

/// Weighted quantile: the value at which the cumulative weight reaches p. Each value counts with
/// half of its own weight; between values the quantile is linear. Equal weights give Hazen's
/// definition, position p n + 1/2. NaN if there is no weight.
double weighted_quantile(std::span<const double> values, std::span<const std::size_t> order,
                         std::span<const double> weights, double p);

/// Smallest number of independent runs whose `rank`-th largest is an upper bound.
std::size_t wilks_runs(double coverage, double confidence, std::size_t rank = 1);

/// Largest rank r for which the r-th largest of `runs` is an upper bound; 0 if there are too few
/// runs.
std::size_t wilks_rank(std::size_t runs, double coverage, double confidence);

}  // namespace cagetol
