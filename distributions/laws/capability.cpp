#include "distributions/laws/capability.hpp"

#include <cmath>

#include "distributions/basics/require.hpp"
#include "distributions/laws/uniform.hpp"

namespace cagetol {

Normal normal_of(const Capability& law) {
  const double tolerance = law.upper - law.lower;
  const double nearest = law.cpk.value_or(law.cpk_lower.value_or(law.cp));
  const double shift = tolerance / 2 * (1 - nearest / law.cp) * (law.cpk_lower ? -1 : 1);
  return {law.lower + tolerance / 2 + law.offset.value_or(shift), tolerance / (6 * law.cp)};
}

void check(const Capability& law) {
  check(Uniform{law.lower, law.upper});
  require(std::isfinite(law.cp) && law.cp > 0, "cp = ", law.cp,
          " is not a finite number > 0; 1.33 is a common requirement");
  require(law.cpk.has_value() + law.cpk_lower.has_value() + law.offset.has_value() <= 1,
          "cpk, cpk_lower and offset each place the mean; give one of them");
  if (law.offset)
    require(std::abs(*law.offset) < (law.upper - law.lower) / 2, "offset = ", *law.offset,
            " puts the mean on or beyond a limit; give a smaller one, or write a normal law");
  if (!law.cpk && !law.cpk_lower) return;
  const char* name = law.cpk ? "cpk" : "cpk_lower";
  const double cpk = law.cpk ? *law.cpk : *law.cpk_lower;
  require(cpk > 0, name, " = ", cpk, " puts the mean on or beyond a limit; give ", name,
          " > 0, or write a normal law");
  require(cpk <= law.cp, name, " = ", cpk, " exceeds cp = ", law.cp,
          ", which no process does; exchange them, or leave ", name, " out for a centred process");
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
