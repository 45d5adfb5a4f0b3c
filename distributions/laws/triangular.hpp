// Triangular law: the density rises linearly from `lower` to `mode` and falls linearly to `upper`.
// `mode` may equal `lower` or `upper`.
#pragma once

#include "distributions/laws/interval.hpp"

namespace cagetol {

struct Triangular {
  double lower = 0;
  double mode = 0;
  double upper = 0;
};

void check(const Triangular& law);
double quantile(const Triangular& law, double p);
double cdf(const Triangular& law, double x);
double pdf(const Triangular& law, double x);
double mean(const Triangular& law);
double standard_deviation(const Triangular& law);
Interval support(const Triangular& law);

}  // namespace cagetol
