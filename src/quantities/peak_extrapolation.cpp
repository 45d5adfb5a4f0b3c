#include "src/quantities/peak_extrapolation.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace cagetol {
namespace {

constexpr double kMinimumShape = -1, kMostShape = 0.5;
constexpr std::array<int, 3> kPoints = {33, 25, 25};  // of the grid: mu, log sigma, xi
constexpr std::size_t kEnoughLaws = 500;              // on the grid
constexpr std::array<double, 7> kCorrelations = {0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9};  // r
constexpr double kFlat = 1e-6;        // |xi| below which the law is Gumbel's
constexpr double kNegligible = 1e-6;  // weight relative to the largest

struct Range {
  double low, high;
  double at(int i, int points) const { return low + (high - low) * i / (points - 1); }
};
using Box = std::array<Range, 3>;  // mu, log sigma, xi

/// A law, the number of independent blocks of the longer time, and how likely it is.
struct Law {
  double mu, sigma, xi, blocks, weight;
};

/// -log G(x); infinite below a lower end, zero above an upper one.
double minus_log_below(const Law& law, double x) {
  const double z = (x - law.mu) / law.sigma;
  if (std::abs(law.xi) < kFlat) return std::exp(-z);
  const double inside = 1 + law.xi * z;
  if (inside <= 0) return law.xi < 0 ? 0 : std::numeric_limits<double>::infinity();
  return std::pow(inside, -1 / law.xi);
}

/// Standard normal score of a value below which a maximum lies with the probability exp(-t).
double normal_score(double t) {
  return t < 0.7 ? gsl_cdf_ugaussian_Qinv(-std::expm1(-t))
                 : gsl_cdf_ugaussian_Pinv(std::exp(-std::min(t, 700.0)));
}

/// Of maxima with this law, of which successive ones are correlated by any of kCorrelations; sets
/// its number of blocks.
double log_likelihood(Law& law, const std::vector<double>& maxima, double blocks) {
  double sum = 0, squares = 0, products = 0, before = 0;
  for (const double x : maxima) {
    const double z = (x - law.mu) / law.sigma, inside = 1 + law.xi * z;
    if (inside <= 0) return -std::numeric_limits<double>::infinity();
    const double steps = std::abs(law.xi) < kFlat ? z : std::log(inside) / law.xi;
    const double exceeded = std::exp(-steps);
    sum -= std::log(law.sigma) + (1 + law.xi) * steps + exceeded;
    const double score = normal_score(exceeded);
    squares += score * score;
    products += score * before;
    before = score;
  }
  const double first = normal_score(minus_log_below(law, maxima.front()));
  const double inner = 2 * squares - first * first - before * before;  // of both ends of each pair
  const auto pairs = static_cast<double>(maxima.size() - 1);
  const double level = normal_score(1 / blocks) / std::numbers::sqrt2;
  double most = 0, likely = 0, independent = 0;
  for (const double r : kCorrelations) {
    const double rest = 1 - r * r, exponent = (r * r * inner - 2 * r * products) / (2 * rest),
                 weight = -0.5 * pairs * std::log(rest) - exponent,
                 share = std::erf(std::sqrt((1 - r) / (1 + r)) * level) / std::erf(level);
    const double before_it = std::exp(most - std::max(most, weight));
    most = std::max(most, weight);
    likely = likely * before_it + std::exp(weight - most);
    independent = independent * before_it +
                  std::exp(weight - most) * std::max(blocks * share, std::min(blocks, 1.0));
  }
  law.blocks = independent / likely;
  return sum + most + std::log(likely);
}

/// The laws on a grid over `box` with their weights, the largest of which is 1.
std::vector<Law> laws_of(const std::vector<double>& maxima, const Box& box, double blocks) {
  std::vector<Law> laws;
  double most = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPoints[0]; ++i)
    for (int j = 0; j < kPoints[1]; ++j)
      for (int k = 0; k < kPoints[2]; ++k) {
        Law law{box[0].at(i, kPoints[0]), std::exp(box[1].at(j, kPoints[1])),
                box[2].at(k, kPoints[2]), 0, 0};
        law.weight = log_likelihood(law, maxima, blocks);
        if (!std::isfinite(law.weight)) continue;
        most = std::max(most, law.weight);
        laws.push_back(law);
      }
  for (Law& law : laws) law.weight = std::exp(law.weight - most);
  std::erase_if(laws, [](const Law& law) { return law.weight < kNegligible; });
  return laws;
}

/// The part of `box` in which laws have weight, one step wider.
Box narrowed(const Box& box, const std::vector<Law>& laws) {
  Box part;
  const auto axis = [&](std::size_t n, auto value) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Law& law : laws) {
      low = std::min(low, value(law));
      high = std::max(high, value(law));
    }
    const double step = (box[n].high - box[n].low) / (kPoints[n] - 1);
    part[n] = {std::max(low - step, box[n].low), std::min(high + step, box[n].high)};
  };
  axis(0, [](const Law& law) { return law.mu; });
  axis(1, [](const Law& law) { return std::log(law.sigma); });
  axis(2, [](const Law& law) { return law.xi; });
  return part;
}

}  // namespace

ExtrapolatedPeak extrapolate_peak(const std::vector<double>& maxima, double blocks) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (maxima.size() < kMinimumBlocks) return {none, none, none};
  const auto n = static_cast<double>(maxima.size());
  double mean = 0, square = 0;
  for (const double x : maxima) mean += x / n;
  for (const double x : maxima) square += (x - mean) * (x - mean) / n;
  const double spread = std::sqrt(square);
  if (!(spread > 1e-12 * std::abs(mean))) return {mean, mean, mean};

  Box box{Range{mean - 2.5 * spread, mean + 2.5 * spread},
          Range{std::log(spread) - 2, std::log(spread) + 2}, Range{kMinimumShape, kMostShape}};
  std::vector<Law> laws = laws_of(maxima, box, blocks);
  // The grid is refined around the likely laws: once for few blocks, more often for many.
  for (int pass = 0; pass == 0 || (pass < 4 && laws.size() < kEnoughLaws); ++pass) {
    box = narrowed(box, laws);
    laws = laws_of(maxima, box, blocks);
  }
  double weight = 0;
  for (const Law& law : laws) weight += law.weight;
  const auto below = [&](double x) {
    double sum = 0;
    for (const Law& law : laws) sum += law.weight * std::exp(-law.blocks * minus_log_below(law, x));
    return sum / weight;
  };
  const auto quantile = [&](double p) {
    double low = mean, high = mean + spread, step = spread;
    while (below(low) > p) low -= step, step *= 2;
    step = spread;
    while (below(high) < p) low = high, high += step, step *= 2;
    while (high - low > 1e-4 * spread) {
      const double middle = (low + high) / 2;
      (below(middle) < p ? low : high) = middle;
    }
    return (low + high) / 2;
  };
  return {quantile(0.5), quantile(0.025), quantile(0.975)};
}

}  // namespace cagetol
