#include "analysis/compare/bias.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cagetol {
namespace {

constexpr double kSteady = 1e-6;  // of the mean

struct Moments {
  double mean = 0, variance = 0;  ///< of the values, not of the mean
};
Moments moments(const std::vector<double>& x) {
  const auto n = static_cast<double>(x.size());
  Moments m;
  for (double v : x) m.mean += v / n;
  for (double v : x) m.variance += (v - m.mean) * (v - m.mean) / (n - 1);
  return m;
}

}  // namespace

const char* verdict_name(BiasVerdict verdict) {
  constexpr const char* kNames[] = {"unbiased", "biased", "unresolved", "steady"};
  return kNames[static_cast<int>(verdict)];
}

double replicas_to_resolve() {
  const double reach = gsl_cdf_ugaussian_Pinv(0.975);
  return std::ceil(2 * reach * reach * kStudySamples);
}

Bias compare_pairs(const std::vector<double>& values, const std::vector<double>& reference,
                   double study_samples) {
  std::vector<double> known, differences;
  for (std::size_t k = 0; k < std::min(values.size(), reference.size()); ++k) {
    if (!std::isfinite(values[k]) || !std::isfinite(reference[k])) continue;
    known.push_back(reference[k]);
    differences.push_back(values[k] - reference[k]);
  }
  Bias b;
  b.pairs = known.size();
  if (known.size() < 2) {
    b.mean = b.bias = b.standard_error = b.upper_limit = b.deviation = b.allowed =
        std::numeric_limits<double>::quiet_NaN();
    return b;
  }
  const Moments r = moments(known), d = moments(differences);
  const auto n = static_cast<double>(known.size());
  b.mean = r.mean;
  b.bias = d.mean;
  b.standard_error = std::sqrt(d.variance / n);
  b.deviation = std::sqrt(r.variance);
  b.allowed = b.deviation / std::sqrt(study_samples);
  const double reach = gsl_cdf_tdist_Pinv(0.975, n - 1) * b.standard_error;
  b.lower_limit = std::max(0.0, std::abs(b.bias) - reach);
  b.upper_limit = std::abs(b.bias) + reach;
  if (b.deviation <= kSteady * std::abs(r.mean))
    b.verdict = BiasVerdict::steady;
  else if (b.upper_limit <= b.allowed)
    b.verdict = BiasVerdict::unbiased;
  else if (b.lower_limit > b.allowed)
    b.verdict = BiasVerdict::biased;
  return b;
}

}  // namespace cagetol
