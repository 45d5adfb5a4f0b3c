// Lognormal law: log(x - shift) is normal with mean log_mean and standard deviation log_sigma.
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

/// log_sigma = 0: a constant.
struct Lognormal {
  double log_mean = 0;
  double log_sigma = 0;
  double shift = 0;
};

void check(const Lognormal& law);
double quantile(const Lognormal& law, double p);
double cdf(const Lognormal& law, double x);
double pdf(const Lognormal& law, double x);
double mean(const Lognormal& law);
double standard_deviation(const Lognormal& law);
Interval support(const Lognormal& law);

}  // namespace cagetol
