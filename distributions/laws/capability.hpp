// Normal law given by process capability and limits:
//
//   sigma = (upper - lower) / (6 cp)
//   mean  = (lower + upper) / 2 + (upper - lower) / 2 (1 - cpk / cp)
//
// cpk refers to the nearer limit, which is here always the UPPER one. A process with its mean below
// the middle is given as a normal law. Without cpk the process is centred (cpk = cp). Parts outside
// the limits occur at the rate that cpk implies; sorted parts have a truncated normal law.
#pragma once

#include <optional>

#include "distributions/laws/interval.hpp"
#include "distributions/laws/normal.hpp"

namespace cagetol {

struct Capability {
  double lower = 0;
  double upper = 0;
  double cp = 1;
  std::optional<double> cpk;
};

/// The equivalent normal law.
Normal normal_of(const Capability& law);

void check(const Capability& law);
double quantile(const Capability& law, double p);
double cdf(const Capability& law, double x);
double pdf(const Capability& law, double x);
double mean(const Capability& law);
double standard_deviation(const Capability& law);
Interval support(const Capability& law);

}  // namespace cagetol
