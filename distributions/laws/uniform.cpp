#include "distributions/laws/uniform.hpp"

#include <algorithm>
#include <cmath>

#include "distributions/basics/require.hpp"

namespace cagetol {

void check(const Uniform& law) {
  require(std::isfinite(law.lower) && std::isfinite(law.upper) && law.lower < law.upper,
          "lower = ", law.lower, " and upper = ", law.upper,
          " are not two finite numbers in ascending order; exchange them, or give a plain number");
}

double quantile(const Uniform& law, double p) {
  return p == 1 ? law.upper : law.lower + (law.upper - law.lower) * p;
}

double cdf(const Uniform& law, double x) {
  return std::clamp((x - law.lower) / (law.upper - law.lower), 0.0, 1.0);
}

double pdf(const Uniform& law, double x) {
  return x < law.lower || x > law.upper ? 0 : 1 / (law.upper - law.lower);
}

double mean(const Uniform& law) {
  return law.lower + (law.upper - law.lower) / 2;
}

double standard_deviation(const Uniform& law) {
  return (law.upper - law.lower) / std::sqrt(12.0);
}

Interval support(const Uniform& law) {
  return {law.lower, law.upper};
}

}  // namespace cagetol
