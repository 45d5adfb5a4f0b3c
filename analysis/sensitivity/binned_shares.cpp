#include "analysis/sensitivity/binned_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostBins = 64;
/// A line through fewer points of a class leaves too little to judge its scatter by.
constexpr double kFewestForLine = 4;

/// Weighted sums over a class: feature less the class' mean (x), output (y).
struct Sums {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

  void add(double dx, double dy, double w) {
    count += w;
    x += w * dx;
    y += w * dy;
    xx += w * dx * dx;
    xy += w * dx * dy;
    yy += w * dy * dy;
  }
};

/// Scatter of the output around the straight line of its class, and the parameters that it took.
struct Residual {
  double squares = 0, parameters = 1;
};
Residual residual_of(const Sums& sums) {
  Residual residual{sums.yy - sums.y * sums.y / sums.count, 1};
  const double xx = sums.xx - sums.x * sums.x / sums.count;
  const double xy = sums.xy - sums.x * sums.y / sums.count;
  if (sums.count < kFewestForLine || !(xx > 1e-9 * sums.xx)) return residual;
  residual.squares = std::max(residual.squares - xy * xy / xx, 0.0);
  residual.parameters = 2;
  return residual;
}

}  // namespace

std::size_t bin_count(std::size_t runs) {
  const double half_root = 0.5 * std::sqrt(static_cast<double>(runs));
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(half_root)), 4,
                                 kMostBins / 2);
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
                    std::span<const double> weights) {
  std::array<Sums, kMostBins> sums{};
  Sums all;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const double w = weights[i];
    if (w == 0 || std::isnan(output[i])) continue;
    sums[binning.bin_of[i]].add(binning.offset[i], output[i], w);
    all.add(0, output[i], w);
  }
  double within = 0, used = 0;
  for (std::size_t bin = 0; bin < binning.bins; ++bin) {
    if (sums[bin].count == 0) continue;
    const Residual residual = residual_of(sums[bin]);
    within += residual.squares;
    used += residual.parameters;
  }
  const double whole = all.yy - all.y * all.y / all.count;
  if (!(whole > 1e-12 * all.yy) || all.count - used < 1) return kUndefined;
  return 1 - within / (all.count - used) / (whole / (all.count - 1));
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
  const std::vector<double> ones(output.size(), 1.0);
  const double value = binned_share(binning, centred, ones);
  bool at_value = true;  // the first call is the estimate itself, the others are resamples
  Estimate estimate = resampling.estimate(
      [&](std::span<const double> weights) {
        const double share = binned_share(binning, centred, weights);
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
                                          std::span<const double> output, std::size_t bins) {
  const Binning binning = make_binning(feature, bins);
  std::vector<ResponsePoint> points(binning.bins);
  std::vector<double> count(binning.bins), squares(binning.bins);
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
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (std::isnan(output[i])) continue;
    const std::size_t bin = binning.bin_of[i];
    squares[bin] += (output[i] - points[bin].mean) * (output[i] - points[bin].mean);
  }
  for (std::size_t bin = 0; bin < binning.bins; ++bin)
    points[bin].standard_error =
        count[bin] > 1 ? std::sqrt(squares[bin] / (count[bin] - 1) / count[bin]) : kUndefined;
  return points;
}

}  // namespace cagetol
