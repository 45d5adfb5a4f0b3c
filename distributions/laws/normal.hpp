// Normal law: density exp(-z^2 / 2) / (sigma sqrt(2 pi)) with z = (x - mean) / sigma.
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

/// sigma = 0 is a plain number.
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
