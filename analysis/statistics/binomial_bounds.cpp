#include "analysis/statistics/binomial_bounds.hpp"

#include <gsl/gsl_cdf.h>

namespace cagetol {
namespace {

/// Sums of weights reach n only up to rounding.
constexpr double kRounding = 1e-9;

/// Solves P(X <= x) = p for a beta variable by bisection: GSL's own inverse gives up at parameters
/// like (999, 1 + 1e-6).
double beta_quantile(double p, double a, double b) {
  double low = 0, high = 1;
  while (high - low > 1e-15) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (gsl_cdf_beta_P(middle, a, b) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

double clopper_pearson_lower(double successes, double trials, double confidence) {
  if (trials <= 0 || successes <= kRounding * trials) return 0;
  const double failures = successes >= trials * (1 - kRounding) ? 0 : trials - successes;
  return beta_quantile(1 - confidence, successes, failures + 1);
}

double clopper_pearson_upper(double successes, double trials, double confidence) {
  return 1 - clopper_pearson_lower(trials - successes, trials, confidence);
}

}  // namespace cagetol
