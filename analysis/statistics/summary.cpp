#include "analysis/statistics/summary.hpp"

#include <fmt/format.h>

#include <cmath>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/study/refused.hpp"

namespace cagetol {

double weighted_mean(std::span<const double> values, std::span<const double> weights) {
  double sum = 0, total = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    sum += weights[i] * values[i];
    total += weights[i];
  }
  return total > 0 ? sum / total : kUndefined;
}

double weighted_standard_deviation(std::span<const double> values,
                                   std::span<const double> weights) {
  const double mean = weighted_mean(values, weights);
  double square = 0, total = 0, squares_of_weights = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    square += weights[i] * (values[i] - mean) * (values[i] - mean);
    total += weights[i];
    squares_of_weights += weights[i] * weights[i];
  }
  const double freedom = total - squares_of_weights / total;
  return freedom > 0 ? std::sqrt(square / freedom) : kUndefined;
}

Estimate quantile_estimate(std::span<const double> values, std::span<const std::size_t> order,
                           double p, const Resampling& resampling, double confidence,
                           std::span<const double> weights) {
  return resampling.estimate(
      [&](std::span<const double> w) { return weighted_quantile(values, order, w, p); }, confidence,
      weights);
}

Summary summarise(const StudyData& runs, std::span<const double> values,
                  const Resampling& resampling, double confidence,
                  std::span<const double> weights) {
  Summary summary;
  const auto order = ascending_order(values);
  summary.defined = order.size();
  summary.quantiles.resize(std::size(kQuantileLevels));
  if (order.empty()) {
    summary.bound_95_refused = "no run has a value";
    return summary;
  }
  summary.smallest = values[order.front()];
  summary.largest = values[order.back()];
  const auto mean = [&](std::span<const double> w) { return weighted_mean(values, w); };
  summary.mean = resampling.estimate(mean, confidence, weights);
  summary.standard_error = resampling.standard_error(mean, weights);
  summary.standard_deviation = resampling.estimate(
      [&](std::span<const double> w) { return weighted_standard_deviation(values, w); }, confidence,
      weights);
  for (std::size_t q = 0; q < summary.quantiles.size(); ++q)
    summary.quantiles[q] =
        quantile_estimate(values, order, kQuantileLevels[q], resampling, confidence, weights);
  try {
    if (!weights.empty()) throw Refused("weighted runs have no such bound");
    summary.bound_95 = wilks_bound(runs, values, 0.95, confidence);
  } catch (const Refused& refusal) {
    summary.bound_95_refused = refusal.what();
  }
  return summary;
}

double wilks_bound(const StudyData& runs, std::span<const double> values, double coverage,
                   double confidence) {
  require_independent_runs(runs, "the distribution-free bound (Wilks)");
  const auto order = ascending_order(values);
  const std::size_t rank = wilks_rank(order.size(), coverage, confidence);
  if (rank == 0)
    throw Refused(
        fmt::format("the distribution-free bound (Wilks) needs at least {} runs, there are {}",
                    wilks_runs(coverage, confidence), order.size()));
  return values[order[order.size() - rank]];
}

}  // namespace cagetol
