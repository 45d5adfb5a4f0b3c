// Gamma law, with t = (x - shift) / scale >= 0:
//   pdf(x) = t^(shape-1) exp(-t) / (scale Gamma(shape))
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Gamma {
  double shape = 1;
  double scale = 1;
  double shift = 0;
};

void check(const Gamma& law);
double quantile(const Gamma& law, double p);
double cdf(const Gamma& law, double x);
double pdf(const Gamma& law, double x);
double mean(const Gamma& law);
double standard_deviation(const Gamma& law);
Interval support(const Gamma& law);

}  // namespace cagetol
