// Normal law conditioned on lower <= x <= upper: a normal process after sorting by a gauge. `mean`
// and `sigma` are those of the process before sorting; mean(law) and standard_deviation(law) are
// those of the accepted parts.
#pragma once

#include <limits>

#include "distributions/laws/interval.hpp"

namespace cagetol {

/// Either limit may be infinite. sigma = 0: a constant, which must lie within the limits.
struct TruncatedNormal {
  double mean = 0;
  double sigma = 0;
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

void check(const TruncatedNormal& law);
double quantile(const TruncatedNormal& law, double p);
double cdf(const TruncatedNormal& law, double x);
double pdf(const TruncatedNormal& law, double x);
double mean(const TruncatedNormal& law);
double standard_deviation(const TruncatedNormal& law);
Interval support(const TruncatedNormal& law);

}  // namespace cagetol
