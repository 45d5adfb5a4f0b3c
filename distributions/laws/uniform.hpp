// Uniform law on [lower, upper]. quantile(0) = lower and quantile(1) = upper exactly.
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Uniform {
  double lower = 0;
  double upper = 0;
};

void check(const Uniform& law);
double quantile(const Uniform& law, double p);
double cdf(const Uniform& law, double x);
double pdf(const Uniform& law, double x);
double mean(const Uniform& law);
double standard_deviation(const Uniform& law);
Interval support(const Uniform& law);

}  // namespace cagetol
