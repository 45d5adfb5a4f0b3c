#include "distributions/laws/gamma.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <limits>

#include "distributions/basics/require.hpp"
#include "distributions/laws/invert_cdf.hpp"

namespace cagetol {

namespace {

// Outside this range the distribution function of GSL loses digits or stops.
constexpr double smallest_gamma_shape = 0.05, largest_gamma_shape = 1e4;

}  // namespace

void check(const Gamma& law) {
  require(law.shape >= smallest_gamma_shape && law.shape <= largest_gamma_shape,
          "shape = ", law.shape, " lies outside ", smallest_gamma_shape, " .. ",
          largest_gamma_shape, "; for a larger shape the law is normal within its accuracy");
  require(std::isfinite(law.scale) && law.scale > 0, "scale = ", law.scale,
          " is not a finite number > 0");
  require(std::isfinite(law.shift), "shift = ", law.shift, " is not a finite number");
}

double quantile(const Gamma& law, double p) {
  if (p == 1) return std::numeric_limits<double>::infinity();
  // 745 is where exp(-x) underflows: far beyond the last quantile below 1.
  const double upper = law.shape + 60 * std::sqrt(law.shape) + 745;
  const double t = invert_cdf([&](double x) { return gsl_cdf_gamma_P(x, law.shape, 1); },
                              [&](double x) { return gsl_cdf_gamma_Q(x, law.shape, 1); }, p, upper);
  return law.shift + law.scale * t;
}

double cdf(const Gamma& law, double x) {
  if (std::isinf(x)) return x > 0 ? 1 : 0;
  return x <= law.shift ? 0 : gsl_cdf_gamma_P(x - law.shift, law.shape, law.scale);
}

double pdf(const Gamma& law, double x) {
  return gsl_ran_gamma_pdf(x - law.shift, law.shape, law.scale);
}

double mean(const Gamma& law) {
  return law.shift + law.scale * law.shape;
}

double standard_deviation(const Gamma& law) {
  return law.scale * std::sqrt(law.shape);
}

Interval support(const Gamma& law) {
  return {law.shift, std::numeric_limits<double>::infinity()};
}

}  // namespace cagetol
