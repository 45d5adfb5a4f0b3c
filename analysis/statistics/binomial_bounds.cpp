#include "analysis/statistics/binomial_bounds.hpp"

#include <gsl/gsl_cdf.h>

namespace cagetol {
namespace {

/// Sums of weights reach n only up to rounding.
constexpr double kRounding = 1e-9;

}  // namespace

double clopper_pearson_lower(double successes, double trials, double confidence) {
  if (trials <= 0 || successes <= kRounding * trials) return 0;
  const double failures = successes >= trials * (1 - kRounding) ? 0 : trials - successes;
  return gsl_cdf_beta_Pinv(1 - confidence, successes, failures + 1);
}

double clopper_pearson_upper(double successes, double trials, double confidence) {
  return 1 - clopper_pearson_lower(trials - successes, trials, confidence);
}

}  // namespace cagetol
