#include "src/quantities/peak_extrapolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cagetol {
namespace {

constexpr double kMinimumShape = -1, kMostShape = 0.5;
constexpr std::array<int, 3> kPoints = {33, 25, 25};  // of the grid: mu, log sigma, xi
constexpr std::size_t kEnoughLaws = 500;              // on the grid
constexpr double kFlat = 1e-6;                        // |xi| below which the law is Gumbel's
constexpr double kNegligible = 1e-6;                  // weight relative to the largest

struct Range {
  double low, high;
  double at(int i, int points) const { return low + (high - low) * i / (points - 1); }
};
using Box = std::array<Range, 3>;  // mu, log sigma, xi

/// A law and how likely it is.
struct Law {
  double mu, sigma, xi, weight;
};

/// -log G(x); infinite below a lower end, zero above an upper one.
double minus_log_below(const Law& law, double x) {
  const double z = (x - law.mu) / law.sigma;
  if (std::abs(law.xi) < kFlat) return std::exp(-z);
  const double inside = 1 + law.xi * z;
  if (inside <= 0) return law.xi < 0 ? 0 : std::numeric_limits<double>::infinity();
  return std::pow(inside, -1 / law.xi);
}

double log_likelihood(const Law& law, const std::vector<double>& maxima) {
  double sum = 0;
  for (const double x : maxima) {
    const double z = (x - law.mu) / law.sigma, inside = 1 + law.xi * z;
    if (inside <= 0) return -std::numeric_limits<double>::infinity();
    const double steps = std::abs(law.xi) < kFlat ? z : std::log(inside) / law.xi;
    sum -= std::log(law.sigma) + (1 + law.xi) * steps + std::exp(-steps);
  }
  return sum;
}

/// The laws on a grid over `box` with their weights, the largest of which is 1.
std::vector<Law> laws_of(const std::vector<double>& maxima, const Box& box) {
  std::vector<Law> laws;
  double most = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPoints[0]; ++i)
    for (int j = 0; j < kPoints[1]; ++j)
      for (int k = 0; k < kPoints[2]; ++k) {
        Law law{box[0].at(i, kPoints[0]), std::exp(box[1].at(j, kPoints[1])),
                box[2].at(k, kPoints[2]), 0};
        law.weight = log_likelihood(law, maxima);
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
  std::vector<Law> laws = laws_of(maxima, box);
  // The grid is refined around the likely laws: once for few blocks, more often for many.
  for (int pass = 0; pass == 0 || (pass < 4 && laws.size() < kEnoughLaws); ++pass) {
    box = narrowed(box, laws);
    laws = laws_of(maxima, box);
  }
  double weight = 0;
  for (const Law& law : laws) weight += law.weight;
  const auto below = [&](double x) {
    double sum = 0;
    for (const Law& law : laws) sum += law.weight * std::exp(-blocks * minus_log_below(law, x));
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
