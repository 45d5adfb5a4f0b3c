#include "analysis/statistics/capability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/statistics/summary.hpp"

namespace cagetol {
namespace {

/// Of a constant that is computed: its scatter is no scatter.
constexpr double kCapabilityRounding = 1e-12;

}  // namespace

ProcessCapability process_capability(std::span<const double> values, std::optional<double> minimum,
                                     std::optional<double> maximum, const Resampling& resampling,
                                     double confidence, std::span<const double> weights) {
  ProcessCapability result;
  const auto order = ascending_order(values);
  result.defined = order.size();
  if (order.size() < 2 || (!minimum && !maximum)) return result;
  const double lowest = values[order.front()], most = values[order.back()];
  if (most - lowest <= kCapabilityRounding * std::max(std::abs(lowest), std::abs(most))) {
    result.percentile_refused = "the quantity does not vary";
    return result;
  }

  const auto nearer_side = [&](double centre, double below, double above) {
    double smallest = std::numeric_limits<double>::infinity();
    if (maximum) smallest = std::min(smallest, (*maximum - centre) / above);
    if (minimum) smallest = std::min(smallest, (centre - *minimum) / below);
    return smallest;
  };
  const auto estimate = [&](const WeightedStatistic& statistic) {
    return resampling.estimate(statistic, confidence, weights);
  };
  const auto at = [&](std::span<const double> w, double p) {
    return weighted_quantile(values, order, w, p);
  };
  if (minimum && maximum)
    result.cp = estimate([&](std::span<const double> w) {
      return (*maximum - *minimum) / (6 * weighted_standard_deviation(values, w));
    });
  result.cpk = estimate([&](std::span<const double> w) {
    const double three_sigma = 3 * weighted_standard_deviation(values, w);
    return nearer_side(weighted_mean(values, w), three_sigma, three_sigma);
  });
  if (order.size() < kFewestForPercentiles) {
    result.percentile_refused =
        fmt::format("the outer percentiles need at least {} runs with a value, there are {}",
                    kFewestForPercentiles, order.size());
    return result;
  }
  if (minimum && maximum)
    result.pp = estimate([&](std::span<const double> w) {
      return (*maximum - *minimum) / (at(w, 0.99865) - at(w, 0.00135));
    });
  result.ppk = estimate([&](std::span<const double> w) {
    const double middle = at(w, 0.5);
    return nearer_side(middle, middle - at(w, 0.00135), at(w, 0.99865) - middle);
  });
  return result;
}

}  // namespace cagetol
