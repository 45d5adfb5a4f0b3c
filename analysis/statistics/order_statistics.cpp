#include "analysis/statistics/order_statistics.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "analysis/study/estimate.hpp"

namespace cagetol {

std::vector<std::size_t> ascending_order(std::span<const double> values) {
  std::vector<std::size_t> order;
  order.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isnan(values[i])) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order;
}

double weighted_quantile(std::span<const double> values, std::span<const std::size_t> order,
                         std::span<const double> weights, double p) {
  double total = 0;
  for (const std::size_t i : order) total += weights[i];
  if (!(total > 0)) return kUndefined;
  const double target = p * total;
  double before = 0;
  double previous_middle = 0, previous_value = kUndefined;
  for (const std::size_t i : order) {
    if (!(weights[i] > 0)) continue;
    const double middle = before + 0.5 * weights[i];
    if (middle >= target) {
      if (std::isnan(previous_value)) return values[i];
      const double part = (target - previous_middle) / (middle - previous_middle);
      return previous_value + part * (values[i] - previous_value);
    }
    before += weights[i];
    previous_middle = middle;
    previous_value = values[i];
  }
  return previous_value;
}

std::size_t wilks_runs(double coverage, double confidence, std::size_t rank) {
  std::size_t runs = rank;
  while (wilks_rank(runs, coverage, confidence) < rank) ++runs;
  return runs;
}

std::size_t wilks_rank(std::size_t runs, double coverage, double confidence) {
  std::size_t rank = 0;
  const auto n = static_cast<unsigned>(runs);
  while (rank < runs &&
         gsl_cdf_binomial_Q(static_cast<unsigned>(rank), 1 - coverage, n) >= confidence)
    ++rank;
  return rank;
}

}  // namespace cagetol
