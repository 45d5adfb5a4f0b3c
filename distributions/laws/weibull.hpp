// Weibull law, for x >= shift:
//   cdf(x) = 1 - exp(-((x - shift) / scale)^shape)
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Weibull {
  double shape = 1;
  double scale = 1;
  double shift = 0;
};

void check(const Weibull& law);
double quantile(const Weibull& law, double p);
double cdf(const Weibull& law, double x);
double pdf(const Weibull& law, double x);
double mean(const Weibull& law);
double standard_deviation(const Weibull& law);
Interval support(const Weibull& law);

}  // namespace cagetol
