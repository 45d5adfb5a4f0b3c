#include "distributions/variance_parts.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

#include "distributions/basics/require.hpp"
#include "distributions/laws/empirical.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kAllowed = 1000;
/// Its inverse powers are the steps of an additive lattice in three dimensions: g^4 = g + 1.
constexpr double kLatticeRoot = 1.2207440846057596;

double lattice(std::size_t point, double dimension) {
  return std::fmod(0.5 + static_cast<double>(point) * std::pow(kLatticeRoot, -dimension), 1);
}

PartsProcess process_of(double mean, double between, double within, double size) {
  return {mean, std::sqrt(std::max(0.0, between - within) / size), std::sqrt(within)};
}

/// The variance that a mean square allows at a probability.
double variance_at(double mean_square, double freedom, double p) {
  return freedom > 0 ? mean_square * freedom / gsl_cdf_chisq_Pinv(p, freedom) : mean_square;
}

}  // namespace

double PartsProcess::total_sigma() const {
  return std::hypot(group_sigma, own_sigma);
}

VarianceParts variance_parts(std::vector<std::vector<double>> groups) {
  const auto k = static_cast<double>(groups.size());
  double parts = 0, inverse_sizes = 0, within = 0;
  Empirical means;
  for (std::vector<double>& group : groups) {
    std::erase_if(group, [](double value) { return std::isnan(value); });
    require(!group.empty(), "a group has no measured value; remove it");
    const auto size = static_cast<double>(group.size());
    parts += size;
    inverse_sizes += 1 / size;
    within += size * std::pow(standard_deviation(Empirical{group}), 2);
    means.values.push_back(mean(Empirical{group}));
  }
  require(parts >= 2, "fewer than two measured values have no scatter; measure more parts");
  const double size = k / inverse_sizes, middle = mean(means);
  within /= std::max(parts - k, 1.0);
  const double between =
      k > 1 ? size * std::pow(standard_deviation(means), 2) * k / (k - 1) : within;
  VarianceParts result{process_of(middle, between, within, size), {}};
  for (std::size_t i = 1; i <= kAllowed; ++i) {
    const double own = variance_at(within, parts - k, lattice(i, 1));
    const double mean_square = k > 1 ? variance_at(between, k - 1, lattice(i, 2)) : own;
    const double error = std::sqrt(mean_square / (k * size));
    for (const double side : {-error, error})
      result.allowed.push_back(process_of(middle + side * gsl_cdf_ugaussian_Pinv(lattice(i, 3)),
                                          mean_square, own, size));
  }
  return result;
}

Interval interval_of(const std::vector<PartsProcess>& allowed,
                     const std::function<double(const PartsProcess&)>& value, double confidence) {
  Empirical values;
  for (const PartsProcess& process : allowed) values.values.push_back(value(process));
  std::sort(values.values.begin(), values.values.end());
  return {quantile(values, (1 - confidence) / 2), quantile(values, (1 + confidence) / 2)};
}

}  // namespace cagetol
