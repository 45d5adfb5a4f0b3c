#include "distributions/laws/beta.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>

#include "distributions/basics/require.hpp"
#include "distributions/laws/invert_cdf.hpp"
#include "distributions/laws/uniform.hpp"

namespace cagetol {

namespace {

// Outside this range the distribution function of GSL loses digits.
constexpr double smallest_shape = 0.05, largest_shape = 1e4;

void check_shape(const char* name, double value) {
  require(value >= smallest_shape && value <= largest_shape, name, " = ", value, " lies outside ",
          smallest_shape, " .. ", largest_shape,
          "; a narrower law is as well written as truncated_normal");
}

double scaled(const Beta& law, double x) {
  return (x - law.lower) / (law.upper - law.lower);
}

}  // namespace

void check(const Beta& law) {
  check(Uniform{law.lower, law.upper});
  check_shape("alpha", law.alpha);
  check_shape("beta", law.beta);
}

double quantile(const Beta& law, double p) {
  if (p == 1) return law.upper;
  const double t =
      invert_cdf([&](double x) { return gsl_cdf_beta_P(x, law.alpha, law.beta); },
                 [&](double x) { return gsl_cdf_beta_Q(x, law.alpha, law.beta); }, p, 1);
  return law.lower + (law.upper - law.lower) * t;
}

double cdf(const Beta& law, double x) {
  return gsl_cdf_beta_P(scaled(law, x), law.alpha, law.beta);
}

double pdf(const Beta& law, double x) {
  return gsl_ran_beta_pdf(scaled(law, x), law.alpha, law.beta) / (law.upper - law.lower);
}

double mean(const Beta& law) {
  return law.lower + (law.upper - law.lower) * law.alpha / (law.alpha + law.beta);
}

double standard_deviation(const Beta& law) {
  const double sum = law.alpha + law.beta;
  return (law.upper - law.lower) / sum * std::sqrt(law.alpha * law.beta / (sum + 1));
}

Interval support(const Beta& law) {
  return {law.lower, law.upper};
}

}  // namespace cagetol
