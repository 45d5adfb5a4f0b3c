#include "analysis/statistics/value_histogram.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {

ValueHistogram value_histogram(std::span<const double> values) {
  ValueHistogram histogram;
  const auto order = ascending_order(values);
  if (order.empty()) return histogram;
  const double low = values[order.front()], high = values[order.back()];
  const auto count = static_cast<double>(order.size());
  if (!(high > low)) {
    const double half = 0.5 * std::max(std::abs(low), 1.0);
    return {{low - half, low + half}, {count}};
  }
  const std::vector<double> equal(values.size(), 1.0);
  const double spread =
      weighted_quantile(values, order, equal, 0.75) - weighted_quantile(values, order, equal, 0.25);
  const double width = 2 * spread / std::cbrt(count);
  const double wanted = width > 0 ? std::ceil((high - low) / width) : 8;
  const auto classes = static_cast<std::size_t>(std::clamp(wanted, 8.0, 40.0));
  histogram.counts.assign(classes, 0.0);
  for (std::size_t k = 0; k <= classes; ++k)
    histogram.edges.push_back(low +
                              (high - low) * static_cast<double>(k) / static_cast<double>(classes));
  for (const std::size_t i : order) {
    const auto k =
        static_cast<std::size_t>((values[i] - low) / (high - low) * static_cast<double>(classes));
    histogram.counts[std::min(k, classes - 1)] += 1;
  }
  return histogram;
}

}  // namespace cagetol
