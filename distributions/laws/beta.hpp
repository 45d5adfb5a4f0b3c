// Beta law between two limits: x = lower + (upper - lower) t, where t has on [0,1] the density
//   t^(alpha-1) (1-t)^(beta-1) / B(alpha, beta)
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Beta {
  double alpha = 1;
  double beta = 1;
  double lower = 0;
  double upper = 0;
};

void check(const Beta& law);
double quantile(const Beta& law, double p);
double cdf(const Beta& law, double x);
double pdf(const Beta& law, double x);
double mean(const Beta& law);
double standard_deviation(const Beta& law);
Interval support(const Beta& law);

}  // namespace cagetol
