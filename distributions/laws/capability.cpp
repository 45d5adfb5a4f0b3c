#include "distributions/laws/capability.hpp"

#include <cmath>

#include "distributions/basics/require.hpp"
#include "distributions/laws/uniform.hpp"

namespace cagetol {

Normal normal_of(const Capability& law) {
  const double tolerance = law.upper - law.lower;
  const double shift = tolerance / 2 * (1 - law.cpk.value_or(law.cp) / law.cp);
  return {law.lower + tolerance / 2 + shift, tolerance / (6 * law.cp)};
}

void check(const Capability& law) {
  check(Uniform{law.lower, law.upper});
  require(std::isfinite(law.cp) && law.cp > 0, "cp = ", law.cp,
          " is not a finite number > 0; 1.33 is a common requirement");
  if (!law.cpk) return;
  require(*law.cpk > 0, "cpk = ", *law.cpk,
          " puts the mean on or beyond a limit; give cpk > 0, or write a normal law");
  require(*law.cpk <= law.cp, "cpk = ", *law.cpk, " exceeds cp = ", law.cp,
          ", which no process does; exchange them, or leave cpk out for a centred process");
}

double quantile(const Capability& law, double p) {
  return quantile(normal_of(law), p);
}

double cdf(const Capability& law, double x) {
  return cdf(normal_of(law), x);
}

double pdf(const Capability& law, double x) {
  return pdf(normal_of(law), x);
}

double mean(const Capability& law) {
  return mean(normal_of(law));
}

double standard_deviation(const Capability& law) {
  return standard_deviation(normal_of(law));
}

Interval support(const Capability& law) {
  return support(normal_of(law));
}

}  // namespace cagetol
