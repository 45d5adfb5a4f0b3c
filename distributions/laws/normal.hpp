// Normal law, with z = (x - mean) / sigma:
//   pdf(x) = exp(-z^2 / 2) / (sigma sqrt(2 pi))
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

/// sigma = 0: a constant.
struct Normal {
  double mean = 0;
  double sigma = 0;
};

void check(const Normal& law);
double quantile(const Normal& law, double p);
double cdf(const Normal& law, double x);
double pdf(const Normal& law, double x);
double mean(const Normal& law);
double standard_deviation(const Normal& law);
Interval support(const Normal& law);

}  // namespace cagetol
