#include "analysis/sensitivity/binned_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostBins = 64;
/// A line through fewer points of a class leaves too little to judge its scatter by.
constexpr double kFewestForLine = 4;

/// Weighted sums over a class: feature less the class' mean (x), output (y).
struct Sums {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, slope = 0;

  void add(double dx, double dy, double w) {
    count += w;
    x += w * dx;
    y += w * dy;
    xx += w * dx * dx;
    xy += w * dx * dy;
  }
  double spread() const { return xx - x * x / count; }
};

/// What the runs of one lot have in one class.
struct Part {
  double count = 0, x = 0, weight = 0;
};

}  // namespace

std::size_t bin_count(std::size_t runs) {
  const double half_root = 0.5 * std::sqrt(static_cast<double>(runs));
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(half_root)), 4,
                                 kMostBins / 2);
}

std::size_t independent_values(std::span<const double> feature, const Lots& lots) {
  std::set<std::pair<std::size_t, double>> distinct;
  for (std::size_t i = 0; i < feature.size(); ++i)
    distinct.emplace(lots.count > 0 ? lots.of[i] : i, feature[i]);
  return distinct.size();
}

Binning make_binning(std::span<const double> feature, std::size_t bins) {
  if (bins == 0) bins = bin_count(feature.size());
  Binning binning{0, std::vector<std::size_t>(feature.size(), 0), {}};
  const auto order = ascending_order(feature);
  std::size_t current = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const bool tied = rank > 0 && feature[order[rank]] == feature[order[rank - 1]];
    const std::size_t wanted = std::min(rank * bins / order.size(), kMostBins - 1);
    if (rank == 0)
      current = 0;
    else if (!tied && wanted > binning.bin_of[order[rank - 1]] && wanted > current)
      current = wanted;
    binning.bin_of[order[rank]] = current;
  }
  // Ties can empty a class: number the classes in use 0, 1, 2, ...
  std::vector<std::size_t> number(kMostBins, kMostBins);
  for (const std::size_t i : order) {
    std::size_t& mine = number[binning.bin_of[i]];
    if (mine == kMostBins) mine = binning.bins++;
    binning.bin_of[i] = mine;
  }
  std::vector<double> sum(binning.bins), count(binning.bins);
  for (const std::size_t i : order)
    sum[binning.bin_of[i]] += feature[i], ++count[binning.bin_of[i]];
  binning.offset.assign(feature.size(), 0.0);
  for (const std::size_t i : order) {
    const std::size_t bin = binning.bin_of[i];
    binning.offset[i] = feature[i] - sum[bin] / count[bin];
  }
  return binning;
}

double binned_share(const Binning& binning, std::span<const double> output,
                    std::span<const double> weights, const Lots& lots) {
  std::array<Sums, kMostBins> sums{};
  std::vector<Part> parts(binning.bins * lots.count);
  double squares = 0, runs = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const double w = weights[i];
    if (w == 0 || std::isnan(output[i])) continue;
    const std::size_t bin = binning.bin_of[i];
    sums[bin].add(binning.offset[i], output[i], w);
    squares += w * output[i] * output[i];
    runs += w;
    if (lots.count == 0) continue;
    Part& part = parts[bin * lots.count + lots.of[i]];
    part.count += 1;
    part.x += binning.offset[i];
    part.weight = w;
  }
  double used = 0, shared = 0;  // traces of the fit and of its blocks of lots
  for (std::size_t bin = 0; bin < binning.bins; ++bin) {
    Sums& at = sums[bin];
    if (at.count == 0) continue;
    double same = lots.count == 0 ? at.count : 0, tilt = 0;
    for (std::size_t lot = 0; lot < lots.count; ++lot) {
      const Part& part = parts[bin * lots.count + lot];
      same += part.weight * part.count * part.count;
      tilt += part.weight * std::pow(part.x - part.count * at.x / at.count, 2);
    }
    used += 1;
    shared += same / at.count;
    // A line takes at least four independent runs.
    if (at.count * at.count < kFewestForLine * same || !(at.spread() > 1e-9 * at.xx)) continue;
    at.slope = (at.xy - at.x * at.y / at.count) / at.spread();
    used += 1;
    shared += lots.count == 0 ? 1 : tilt / at.spread();
  }
  std::vector<double> residual(output.size(), kUndefined);
  for (std::size_t i = 0; i < output.size(); ++i) {
    const Sums& at = sums[binning.bin_of[i]];
    if (weights[i] == 0) continue;
    residual[i] = output[i] - at.y / at.count - at.slope * (binning.offset[i] - at.x / at.count);
  }
  const double whole = run_variance(output, weights, lots).whole();
  if (!(whole > 1e-12 * squares / runs)) return kUndefined;
  return 1 - residual_variance(residual, weights, lots, used, shared).whole() / whole;
}

Estimate binned_share_estimate(const Binning& binning, std::span<const double> output,
                               const Resampling& resampling, double confidence) {
  // Centred: sums of squares of large numbers that vary little would lose their digits.
  double mean = 0, defined = 0;
  for (const double y : output)
    if (!std::isnan(y)) mean += y, defined += 1;
  mean /= std::max(defined, 1.0);
  std::vector<double> centred(output.begin(), output.end());
  for (double& y : centred) y -= mean;

  double excess = 0, count = 0;
  const Lots lots = lots_of(resampling);
  const std::vector<double> ones(output.size(), 1.0);
  const double value = binned_share(binning, centred, ones, lots);
  bool at_value = true;  // the first call is the estimate itself, the others are resamples
  Estimate estimate = resampling.estimate(
      [&](std::span<const double> weights) {
        const double share = binned_share(binning, centred, weights, lots);
        if (!at_value && !std::isnan(share)) excess += share - value, count += 1;
        at_value = false;
        return share;
      },
      confidence);
  if (resampling.kind() != IntervalKind::lots || count == 0) return estimate;
  estimate.lower -= excess / count;
  estimate.upper -= excess / count;
  return estimate;
}

std::vector<ResponsePoint> response_curve(std::span<const double> feature,
                                          std::span<const double> output, std::size_t bins,
                                          const Lots& lots) {
  const Binning binning = make_binning(feature, bins);
  std::vector<ResponsePoint> points(binning.bins);
  std::vector<double> count(binning.bins), squares(binning.bins), groups(binning.bins);
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (std::isnan(output[i])) continue;
    const std::size_t bin = binning.bin_of[i];
    count[bin] += 1;
    points[bin].feature += feature[i];
    points[bin].mean += output[i];
  }
  for (std::size_t bin = 0; bin < binning.bins; ++bin) {
    points[bin].feature /= count[bin];
    points[bin].mean /= count[bin];
  }
  std::map<std::pair<std::size_t, std::size_t>, double> sums;  // of a class and a lot
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (std::isnan(output[i])) continue;
    const std::size_t bin = binning.bin_of[i];
    sums[{bin, lots.count > 0 ? lots.of[i] : i}] += output[i] - points[bin].mean;
  }
  for (const auto& [where, sum] : sums) {
    squares[where.first] += sum * sum;
    groups[where.first] += 1;
  }
  for (std::size_t bin = 0; bin < binning.bins; ++bin)
    if (groups[bin] > 1)
      points[bin].standard_error =
          std::sqrt(squares[bin] * groups[bin] / (groups[bin] - 1)) / count[bin];
  return points;
}

}  // namespace cagetol
