#include "distributions/laws/weibull.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <limits>

#include "distributions/basics/require.hpp"

namespace cagetol {

void check(const Weibull& law) {
  require(std::isfinite(law.shape) && law.shape >= 0.05, "shape = ", law.shape,
          " is not a finite number >= 0.05; 2 is a common value, 1 the exponential law");
  require(std::isfinite(law.scale) && law.scale > 0, "scale = ", law.scale,
          " is not a finite number > 0; it is the 63 % value less the shift");
  require(std::isfinite(law.shift), "shift = ", law.shift, " is not a finite number");
}

double quantile(const Weibull& law, double p) {
  return law.shift + gsl_cdf_weibull_Pinv(p, law.scale, law.shape);
}

double cdf(const Weibull& law, double x) {
  return x <= law.shift ? 0 : gsl_cdf_weibull_P(x - law.shift, law.scale, law.shape);
}

double pdf(const Weibull& law, double x) {
  return gsl_ran_weibull_pdf(x - law.shift, law.scale, law.shape);
}

double mean(const Weibull& law) {
  return law.shift + law.scale * std::tgamma(1 + 1 / law.shape);
}

// Gamma(1 + 2/k) / Gamma(1 + 1/k)^2 - 1 by its logarithm: the difference of the two would cancel
// for a large shape k.
double standard_deviation(const Weibull& law) {
  const double first = std::lgamma(1 + 1 / law.shape);
  const double second = std::lgamma(1 + 2 / law.shape);
  return law.scale * std::exp(first) * std::sqrt(std::expm1(second - 2 * first));
}

Interval support(const Weibull& law) {
  return {law.shift, std::numeric_limits<double>::infinity()};
}

}  // namespace cagetol
