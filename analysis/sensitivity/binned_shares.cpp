#include "analysis/sensitivity/binned_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostBins = 64;

}  // namespace

std::size_t bin_count(std::size_t runs) {
  const auto root = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(runs))));
  return std::clamp<std::size_t>(root, 4, kMostBins);
}

Binning make_binning(std::span<const double> feature, std::size_t bins) {
  if (bins == 0) bins = bin_count(feature.size());
  Binning binning{0, std::vector<std::size_t>(feature.size(), 0)};
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
  return binning;
}

double binned_share(const Binning& binning, std::span<const double> output,
                    std::span<const double> weights) {
  std::array<double, kMostBins> count{}, sum{};
  double all = 0, total = 0, squares = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const double y = output[i], w = weights[i];
    if (w == 0 || std::isnan(y)) continue;
    const std::size_t bin = binning.bin_of[i];
    count[bin] += w;
    sum[bin] += w * y;
    all += w;
    total += w * y;
    squares += w * y * y;
  }
  double between = 0, used = 0;
  for (std::size_t bin = 0; bin < binning.bins; ++bin) {
    if (count[bin] == 0) continue;
    between += sum[bin] * sum[bin] / count[bin];
    used += 1;
  }
  const double whole = squares - total * total / all;
  if (!(whole > 1e-12 * squares) || all - used < 1) return kUndefined;
  return 1 - (squares - between) / (all - used) / (whole / (all - 1));
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
