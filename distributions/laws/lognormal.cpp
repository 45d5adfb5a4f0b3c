#include "distributions/laws/lognormal.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <limits>

#include "distributions/basics/require.hpp"

namespace cagetol {

void check(const Lognormal& law) {
  require(std::isfinite(law.log_mean), "log_mean = ", law.log_mean, " is not a finite number");
  require(std::isfinite(law.log_sigma) && law.log_sigma >= 0, "log_sigma = ", law.log_sigma,
          " is no standard deviation; give a finite number >= 0 (of log(x), not of x)");
  require(std::isfinite(law.shift), "shift = ", law.shift, " is not a finite number");
}

double quantile(const Lognormal& law, double p) {
  if (law.log_sigma == 0) return law.shift + std::exp(law.log_mean);
  return law.shift + std::exp(law.log_mean + law.log_sigma * gsl_cdf_ugaussian_Pinv(p));
}

double cdf(const Lognormal& law, double x) {
  if (law.log_sigma == 0) return x >= quantile(law, 0.5) ? 1 : 0;
  if (x <= law.shift) return 0;
  return gsl_cdf_ugaussian_P((std::log(x - law.shift) - law.log_mean) / law.log_sigma);
}

double pdf(const Lognormal& law, double x) {
  if (law.log_sigma == 0) refuse_density("a lognormal law with log_sigma = 0 is a plain number");
  if (x <= law.shift) return 0;
  return gsl_ran_lognormal_pdf(x - law.shift, law.log_mean, law.log_sigma);
}

double mean(const Lognormal& law) {
  return law.shift + std::exp(law.log_mean + law.log_sigma * law.log_sigma / 2);
}

double standard_deviation(const Lognormal& law) {
  const double variance_of_log = law.log_sigma * law.log_sigma;
  return std::exp(law.log_mean + variance_of_log / 2) * std::sqrt(std::expm1(variance_of_log));
}

Interval support(const Lognormal& law) {
  if (law.log_sigma == 0) return {mean(law), mean(law)};
  return {law.shift, std::numeric_limits<double>::infinity()};
}

}  // namespace cagetol
