#include "distributions/laws/empirical.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "distributions/basics/require.hpp"

namespace cagetol {

Empirical make_empirical(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {std::move(values)};
}

void check(const Empirical& law) {
  require(!law.values.empty(), "there are no measured values; name a column that holds some");
  for (const double value : law.values) {
    require(std::isfinite(value), "measured value ", value,
            " is not a finite number; remove it from the file");
  }
  require(std::is_sorted(law.values.begin(), law.values.end()),
          "measured values are not ascending; build the law with make_empirical");
}

double quantile(const Empirical& law, double p) {
  const double count = static_cast<double>(law.values.size());
  double rank = std::clamp(std::ceil(p * count), 1.0, count);
  // p * count is rounded; cdf() divides, and the two must agree on which value reaches p.
  if (rank > 1 && (rank - 1) / count >= p) --rank;
  if (rank < count && rank / count < p) ++rank;
  return law.values[static_cast<std::size_t>(rank) - 1];
}

double cdf(const Empirical& law, double x) {
  const auto above = std::upper_bound(law.values.begin(), law.values.end(), x);
  return static_cast<double>(above - law.values.begin()) / static_cast<double>(law.values.size());
}

double pdf(const Empirical&, double) {
  refuse_density("an empirical law consists of single measured values");
}

double mean(const Empirical& law) {
  return std::accumulate(law.values.begin(), law.values.end(), 0.0) /
         static_cast<double>(law.values.size());
}

// Of the law itself (divided by n), not an estimate for the population that the values came from.
double standard_deviation(const Empirical& law) {
  const double centre = mean(law);
  double sum = 0;
  for (const double value : law.values) sum += (value - centre) * (value - centre);
  return std::sqrt(sum / static_cast<double>(law.values.size()));
}

Interval support(const Empirical& law) {
  return {law.values.front(), law.values.back()};
}

}  // namespace cagetol
