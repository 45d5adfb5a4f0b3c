// Histogram law: constant density in each bin edges[i] .. edges[i+1], whose probability is
// proportional to weights[i].
#pragma once

#include <vector>

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Histogram {
  std::vector<double> edges;    ///< ascending, one more than weights
  std::vector<double> weights;  ///< not negative, any sum > 0
};

void check(const Histogram& law);
double quantile(const Histogram& law, double p);
double cdf(const Histogram& law, double x);
double pdf(const Histogram& law, double x);
double mean(const Histogram& law);
double standard_deviation(const Histogram& law);
Interval support(const Histogram& law);

}  // namespace cagetol
