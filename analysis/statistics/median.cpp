#include "analysis/statistics/median.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cagetol {

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

double median_of_whole(std::vector<double> values) {
  for (const double value : values)
    if (std::isnan(value)) return value;
  return median(std::move(values));
}

}  // namespace cagetol
