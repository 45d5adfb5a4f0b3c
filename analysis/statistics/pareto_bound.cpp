#include "analysis/statistics/pareto_bound.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace cagetol {
namespace {

constexpr double kLeastShape = -0.5, kStraight = 1e-6;  ///< xi, and that of an exponential law
constexpr double kHeavyKurtosis = 3;                    ///< in standard errors of a normal law's
constexpr double kLogShares[] = {-60, -1e-6};           ///< of ln(p / zeta)

/// Largest value of a function that has one maximum: at `points` places, then between the
/// neighbours of the best by golden section. `at` becomes its place.
double largest(const std::function<double(double)>& function, const double (&range)[2], int points,
               int sections, double& at) {
  const double step = (range[1] - range[0]) / (points - 1);
  double best = -HUGE_VAL;
  for (int i = 0; i < points; ++i)
    if (const double x = range[0] + i * step, value = function(x); value > best)
      best = value, at = x;
  constexpr double golden = 0.6180339887498949;
  double low = std::max(at - step, range[0]), high = std::min(at + step, range[1]);
  for (int i = 0; i < sections; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    const double of_left = function(left), of_right = function(right);
    (of_left > of_right ? high : low) = of_left > of_right ? right : left;
    if (std::max(of_left, of_right) > best)
      best = std::max(of_left, of_right), at = of_left > of_right ? left : right;
  }
  return best;
}

/// l(p, xi) of the excesses; `reach` are these divided by d.
double likelihood(const std::vector<double>& reach, double d, double log_share, double xi) {
  const auto k = static_cast<double>(reach.size());
  if (std::abs(xi) < kStraight) xi = kStraight;
  const double growth = std::expm1(-xi * log_share);  // xi d / sigma
  double logs = 0;
  for (std::size_t i = 0; i < reach.size();) {
    double product = 1;  // of eight terms: one logarithm
    for (const std::size_t end = std::min(i + 8, reach.size()); i < end; ++i) {
      const double term = 1 + growth * reach[i];
      if (!(term > 0)) return -HUGE_VAL;
      product *= term;
    }
    logs += std::log(product);
  }
  return -k * std::log(xi * d / growth) - (1 + 1 / xi) * logs;
}

}  // namespace

double pareto_bound(std::span<const double> values, double limit, double threshold_share,
                    double confidence) {
  const auto n = static_cast<double>(values.size());
  const auto count = static_cast<std::size_t>(std::ceil(threshold_share * n));
  if (count < 10 || count >= values.size()) return 1;
  std::vector<double> falling(values.begin(), values.end());
  std::sort(falling.begin(), falling.end(), std::greater<>());
  const double threshold = falling[count], d = limit - threshold, floor = 1e-3 / n,
               zeta = static_cast<double>(count) / n;
  if (!(d > 0) || falling.front() == threshold) return d > 0 ? floor : 1;
  falling.resize(count);
  for (double& value : falling) value = (value - threshold) / d;
  const bool is_heavy =
      gsl_stats_kurtosis(values.data(), 1, values.size()) > kHeavyKurtosis * std::sqrt(24 / n);
  const double shapes[] = {is_heavy ? 0 : kLeastShape, 1};
  double place = 0;
  const auto profile = [&](double log_share) {
    const auto by_shape = [&](double xi) { return likelihood(falling, d, log_share, xi); };
    return largest(by_shape, shapes, 31, 12, place);
  };
  double likeliest = 0;
  const double most = largest(profile, kLogShares, 61, 20, likeliest);
  const double z = gsl_cdf_ugaussian_Pinv(confidence), least = most - z * z / 2;
  double low = std::max(likeliest, std::log(floor / zeta)), high = kLogShares[1];
  if (profile(low) < least) return floor;
  while (high - low > 1e-3) {
    const double middle = (low + high) / 2;
    (profile(middle) < least ? high : low) = middle;
  }
  return zeta * std::exp(high);
}

double extrapolated_bound(std::span<const double> values, double limit, double confidence) {
  double bound = 0;
  for (const double share : {50.0 / static_cast<double>(values.size()), 0.05, 0.1, 0.15, 0.2})
    bound = std::max(bound, pareto_bound(values, limit, share, confidence));
  return bound;
}

}  // namespace cagetol
