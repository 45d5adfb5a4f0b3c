#include "distributions/laws/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "distributions/basics/require.hpp"

namespace cagetol {

namespace {

double total(const Histogram& law) {
  return std::accumulate(law.weights.begin(), law.weights.end(), 0.0);
}

double width(const Histogram& law, std::size_t bin) {
  return law.edges[bin + 1] - law.edges[bin];
}

double middle(const Histogram& law, std::size_t bin) {
  return law.edges[bin] + width(law, bin) / 2;
}

}  // namespace

void check(const Histogram& law) {
  require(!law.weights.empty() && law.edges.size() == law.weights.size() + 1, law.edges.size(),
          " edges and ", law.weights.size(),
          " weights do not make bins; give one weight for each bin and one edge more");
  for (std::size_t i = 0; i < law.weights.size(); ++i) {
    require(std::isfinite(law.edges[i]) && std::isfinite(law.edges[i + 1]) && width(law, i) > 0,
            "edges ", law.edges[i], " and ", law.edges[i + 1],
            " are not finite and ascending; sort the edges and join bins of zero width");
    require(std::isfinite(law.weights[i]) && law.weights[i] >= 0, "weight ", law.weights[i],
            " is not a finite number >= 0; give counts or shares");
  }
  require(total(law) > 0, "all weights are zero; give counts or shares");
}

double quantile(const Histogram& law, double p) {
  const double target = p * total(law);
  double below = 0;
  double x = support(law).lower;
  for (std::size_t i = 0; i < law.weights.size() && below < target; ++i) {
    if (law.weights[i] == 0) continue;
    const double share = (target - below) / law.weights[i];
    x = share >= 1 ? law.edges[i + 1] : law.edges[i] + share * width(law, i);
    below += law.weights[i];
  }
  return x;
}

double cdf(const Histogram& law, double x) {
  double below = 0;
  for (std::size_t i = 0; i < law.weights.size() && x > law.edges[i]; ++i) {
    below += law.weights[i] * std::min(1.0, (x - law.edges[i]) / width(law, i));
  }
  return below / total(law);
}

double pdf(const Histogram& law, double x) {
  if (x < law.edges.front() || x > law.edges.back()) return 0;
  const auto above = std::upper_bound(law.edges.begin(), law.edges.end() - 1, x);
  const std::size_t bin = static_cast<std::size_t>(above - law.edges.begin()) - 1;
  return law.weights[bin] / total(law) / width(law, bin);
}

double mean(const Histogram& law) {
  double sum = 0;
  for (std::size_t i = 0; i < law.weights.size(); ++i) sum += law.weights[i] * middle(law, i);
  return sum / total(law);
}

double standard_deviation(const Histogram& law) {
  const double centre = mean(law);
  double sum = 0;
  for (std::size_t i = 0; i < law.weights.size(); ++i) {
    const double offset = middle(law, i) - centre;
    sum += law.weights[i] * (offset * offset + width(law, i) * width(law, i) / 12);
  }
  return std::sqrt(sum / total(law));
}

Interval support(const Histogram& law) {
  std::size_t first = 0, last = law.weights.size() - 1;
  while (law.weights[first] == 0) ++first;
  while (law.weights[last] == 0) --last;
  return {law.edges[first], law.edges[last + 1]};
}

}  // namespace cagetol
