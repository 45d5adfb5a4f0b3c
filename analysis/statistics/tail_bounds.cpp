#include "analysis/statistics/tail_bounds.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <cmath>
#include <functional>
#include <vector>

namespace cagetol {
namespace {

/// Beyond this distance in standard deviations a normal law has nothing: 1e-23.
constexpr double kFarthestScore = 10;
constexpr double kScorePrecision = 1e-4;  // of that distance

/// Of the noncentral t law.
double noncentral_t_below(double t, double freedom, double noncentrality) {
  return boost::math::cdf(boost::math::non_central_t(freedom, noncentrality), t);
}

bool is_beyond(std::span<const double> values, double limit) {
  return std::any_of(values.begin(), values.end(), [limit](double x) { return x > limit; });
}

/// From the number of values alone, none of which is beyond the limit.
double bound_by_count(std::size_t count, double confidence) {
  return 1 - std::pow(1 - confidence, 1 / static_cast<double>(count));
}

}  // namespace

double normal_tail_bound(std::span<const double> values, double limit, double confidence) {
  const std::size_t count = values.size();
  if (count < 2 || is_beyond(values, limit)) return 1;
  const double mean = gsl_stats_mean(values.data(), 1, count);
  const double deviation = gsl_stats_sd_m(values.data(), 1, count, mean);
  if (!(deviation > 0)) return bound_by_count(count, confidence);
  const auto n = static_cast<double>(count);
  const double t = std::sqrt(n) * (limit - mean) / deviation;
  double low = -kFarthestScore, high = kFarthestScore;
  while (high - low > kScorePrecision) {
    const double z = 0.5 * (low + high);
    (noncentral_t_below(t, n - 1, std::sqrt(n) * z) > confidence ? low : high) = z;
  }
  return gsl_cdf_ugaussian_Q(low);
}

double exponential_tail_bound(std::span<const double> values, double limit, double confidence) {
  const std::size_t count = values.size();
  if (count < 2 || is_beyond(values, limit)) return 1;
  std::vector<double> falling(values.begin(), values.end());
  std::sort(falling.begin(), falling.end(), std::greater<>());
  const std::size_t outer = (count + 3) / 4;
  const double begin = falling[outer];
  const double excess = gsl_stats_mean(falling.data(), 1, outer) - begin;
  if (!(excess > 0)) return bound_by_count(count, confidence);
  const auto k = static_cast<double>(outer);
  const double largest_excess = excess * 2 * k / gsl_cdf_chisq_Pinv(1 - confidence, 2 * k);
  return k / static_cast<double>(count) * std::exp(-(limit - begin) / largest_excess);
}

double tail_bound(std::span<const double> values, double limit, double confidence) {
  return std::max(normal_tail_bound(values, limit, confidence),
                  exponential_tail_bound(values, limit, confidence));
}

}  // namespace cagetol
