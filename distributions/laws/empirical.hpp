// Measured values with equal probability. The distribution function is a step function, and
// quantile(p) is the smallest value x with cdf(x) >= p, so only measured values are drawn. The law
// has no density: pdf throws std::domain_error.
#pragma once

#include <vector>

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Empirical {
  std::vector<double> values;  ///< ascending; make_empirical sorts
};

Empirical make_empirical(std::vector<double> values);

void check(const Empirical& law);
double quantile(const Empirical& law, double p);
double cdf(const Empirical& law, double x);
double pdf(const Empirical& law, double x);
double mean(const Empirical& law);
double standard_deviation(const Empirical& law);
Interval support(const Empirical& law);

}  // namespace cagetol
