// Normal law given by process capability and limits:
//
//   sigma = (upper - lower) / (6 cp)
//   mean  = (lower + upper) / 2 + offset
//
// In place of the offset of the mean, its distance from the nearer limit may be given: cpk to the
// upper one, cpk_lower to the lower one,
//   offset = +-(upper - lower) / 2 (1 - cpk / cp)
// With none of the three the process is centred. Parts outside the limits occur at the rate that
// the law implies; sorted parts have a truncated normal law.
#pragma once

#include <optional>

#include "distributions/laws/interval.hpp"
#include "distributions/laws/normal.hpp"

namespace cagetol {

struct Capability {
  double lower = 0;
  double upper = 0;
  double cp = 1;
  std::optional<double> cpk = {}, cpk_lower = {}, offset = {};
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
