#include "distributions/laws/truncated_normal.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "distributions/basics/require.hpp"
#include "distributions/laws/normal.hpp"

namespace cagetol {

namespace {

// The limits in units of sigma about the mean, with the probability between them and beyond each.
// When both limits lie above the mean, all of it is computed from upper tails, which keep their
// digits where 1 - P would not.
struct Truncation {
  double a, b;
  bool above_mean;
  double below_a, beyond_a, beyond_b, mass;

  explicit Truncation(const TruncatedNormal& law)
      : a((law.lower - law.mean) / law.sigma),
        b((law.upper - law.mean) / law.sigma),
        above_mean(a > 0),
        below_a(gsl_cdf_ugaussian_P(a)),
        beyond_a(gsl_cdf_ugaussian_Q(a)),
        beyond_b(gsl_cdf_ugaussian_Q(b)),
        mass(above_mean ? beyond_a - beyond_b : gsl_cdf_ugaussian_P(b) - below_a) {}

  double quantile(double p) const {
    const double beyond = p < 0.5 ? beyond_a - p * mass : beyond_b + (1 - p) * mass;
    const double below = below_a + p * mass;
    return above_mean || below > 0.5 ? gsl_cdf_ugaussian_Qinv(beyond)
                                     : gsl_cdf_ugaussian_Pinv(below);
  }

  double cdf(double z) const {
    return (above_mean ? beyond_a - gsl_cdf_ugaussian_Q(z) : gsl_cdf_ugaussian_P(z) - below_a) /
           mass;
  }
};

struct Moments {
  double mean, standard_deviation;
};

// Gauss-Legendre quadrature of the standardised law: the closed forms lose all digits for narrow or
// far truncation. Beyond the range kept here the density is below 1e-18 of its peak.
Moments standard_moments(const Truncation& cut) {
  constexpr double negligible = 83;
  const double peak = std::clamp(0.0, cut.a, cut.b);
  const double reach = std::sqrt(peak * peak + negligible);
  const double from = std::max(cut.a, -reach);
  const double to = std::min(cut.b, reach);
  const auto relative_density = [&](double z) { return std::exp((peak - z) * (peak + z) / 2); };

  constexpr std::size_t nodes = 128;
  const std::unique_ptr<gsl_integration_glfixed_table,
                        decltype(&gsl_integration_glfixed_table_free)>
      rule(gsl_integration_glfixed_table_alloc(nodes), &gsl_integration_glfixed_table_free);
  const auto integral = [&](const auto& f) {
    double sum = 0;
    for (std::size_t i = 0; i < nodes; ++i) {
      double z = 0, weight = 0;
      gsl_integration_glfixed_point(from, to, i, &z, &weight, rule.get());
      sum += weight * f(z);
    }
    return sum;
  };
  const double total = integral(relative_density);
  const double centre =
      peak + integral([&](double z) { return (z - peak) * relative_density(z); }) / total;
  const double variance =
      integral([&](double z) { return (z - centre) * (z - centre) * relative_density(z); }) / total;
  return {centre, std::sqrt(variance)};
}

}  // namespace

void check(const TruncatedNormal& law) {
  check(Normal{law.mean, law.sigma});
  require(law.lower < law.upper, "lower = ", law.lower, " is not below upper = ", law.upper,
          "; exchange them, or leave the law out for a plain number");
  if (law.sigma == 0) {
    require(law.lower <= law.mean && law.mean <= law.upper, "sigma = 0 and mean = ", law.mean,
            " lies outside lower = ", law.lower, " .. upper = ", law.upper,
            ": nothing is left; move the mean or the limits");
    return;
  }
  require(Truncation(law).mass > 0, "no probability is left between lower = ", law.lower,
          " and upper = ", law.upper, " for mean = ", law.mean, " and sigma = ", law.sigma,
          "; move the limits towards the mean");
}

double quantile(const TruncatedNormal& law, double p) {
  if (law.sigma == 0) return law.mean;
  if (p == 0) return law.lower;
  if (p == 1) return law.upper;
  return std::clamp(law.mean + law.sigma * Truncation(law).quantile(p), law.lower, law.upper);
}

double cdf(const TruncatedNormal& law, double x) {
  if (law.sigma == 0) return x >= law.mean ? 1 : 0;
  if (x <= law.lower) return 0;
  if (x >= law.upper) return 1;
  return std::clamp(Truncation(law).cdf((x - law.mean) / law.sigma), 0.0, 1.0);
}

double pdf(const TruncatedNormal& law, double x) {
  if (law.sigma == 0) refuse_density("a truncated normal law with sigma = 0 is a plain number");
  if (x < law.lower || x > law.upper) return 0;
  return gsl_ran_gaussian_pdf(x - law.mean, law.sigma) / Truncation(law).mass;
}

double mean(const TruncatedNormal& law) {
  if (law.sigma == 0) return law.mean;
  return law.mean + law.sigma * standard_moments(Truncation(law)).mean;
}

double standard_deviation(const TruncatedNormal& law) {
  if (law.sigma == 0) return 0;
  return law.sigma * standard_moments(Truncation(law)).standard_deviation;
}

Interval support(const TruncatedNormal& law) {
  if (law.sigma == 0) return {law.mean, law.mean};
  return {law.lower, law.upper};
}

}  // namespace cagetol
