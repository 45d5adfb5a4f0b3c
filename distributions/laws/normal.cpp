#include "distributions/laws/normal.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <limits>

#include "distributions/basics/require.hpp"

namespace cagetol {

void check(const Normal& law) {
  require(std::isfinite(law.mean), "mean = ", law.mean, " is not a finite number");
  require(std::isfinite(law.sigma) && law.sigma >= 0, "sigma = ", law.sigma,
          " is no standard deviation; give a finite number >= 0");
}

double quantile(const Normal& law, double p) {
  return law.sigma == 0 ? law.mean : law.mean + law.sigma * gsl_cdf_ugaussian_Pinv(p);
}

double cdf(const Normal& law, double x) {
  if (law.sigma == 0) return x >= law.mean ? 1 : 0;
  return gsl_cdf_ugaussian_P((x - law.mean) / law.sigma);
}

double pdf(const Normal& law, double x) {
  if (law.sigma == 0) refuse_density("a normal law with sigma = 0 is a plain number");
  return gsl_ran_gaussian_pdf(x - law.mean, law.sigma);
}

double mean(const Normal& law) {
  return law.mean;
}

double standard_deviation(const Normal& law) {
  return law.sigma;
}

Interval support(const Normal& law) {
  if (law.sigma == 0) return {law.mean, law.mean};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {-infinity, infinity};
}

}  // namespace cagetol
