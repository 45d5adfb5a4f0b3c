#include "analysis/sensitivity/binned_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "analysis/statistics/lot_variance.hpp"
#include "analysis/statistics/order_statistics.hpp"

namespace cagetol {
namespace {

constexpr std::size_t kMostBins = 64;
/// A line through fewer points of a class leaves too little to judge its scatter by.
constexpr double kFewestForLine = 4;

/// Weighted sums over a class: feature less the class' mean (x), output (y), and those of the
/// products with mates of the lot.
struct Sums {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0, mates = 0, mates_xx = 0, slope = 0;
};

}  // namespace

std::size_t bin_count(std::size_t values) {
  const double half_root = 0.5 * std::sqrt(static_cast<double>(values));
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::lround(half_root)), 4,
                                 kMostBins / 2);
}

Binning make_binning(std::span<const double> feature, std::size_t bins,
                     std::vector<std::size_t> lot_of) {
  lot_of.resize(feature.size());
  if (lot_of == std::vector<std::size_t>(feature.size()))
    std::iota(lot_of.begin(), lot_of.end(), 0);
  std::set<std::pair<std::size_t, double>> values;
  for (std::size_t i = 0; i < feature.size(); ++i) values.emplace(lot_of[i], feature[i]);
  if (bins == 0) bins = bin_count(values.size());
  Binning binning{0, std::vector<std::size_t>(feature.size(), 0), {}, lot_of, {}};
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
  std::map<std::pair<std::size_t, std::size_t>, Binning::Mates> mates;
  const auto mates_of = [&](std::size_t i) -> auto& {
    return mates[{binning.bin_of[i], lot_of[i]}];
  };
  for (const std::size_t i : order) mates_of(i).runs += 1, mates_of(i).offset += binning.offset[i];
  for (std::size_t i = 0; i < feature.size(); ++i) binning.mates.push_back(mates_of(i));
  return binning;
}

double binned_share(const Binning& binning, std::span<const double> output,
                    std::span<const double> weights) {
  std::array<Sums, kMostBins> sums{};
  double squares = 0, runs = 0;
  for (std::size_t i = 0; i < output.size(); ++i) {
    const double w = weights[i], x = binning.offset[i], y = output[i];
    if (w == 0 || std::isnan(y)) continue;
    Sums& at = sums[binning.bin_of[i]];
    at.count += w;
    at.x += w * x;
    at.y += w * y;
    at.xx += w * x * x;
    at.xy += w * x * y;
    at.mates += w * binning.mates[i].runs;
    at.mates_xx += w * x * binning.mates[i].offset;
    squares += w * y * y;
    runs += w;
  }
  double used = 0, shared = 0;  // P and R of lot_variance.hpp
  for (std::size_t bin = 0; bin < binning.bins; ++bin) {
    Sums& at = sums[bin];
    if (at.count == 0) continue;
    used += 1;
    shared += at.mates / at.count;
    const double spread = at.xx - at.x * at.x / at.count;
    // As many lots as a line takes.
    if (at.count * at.count < kFewestForLine * at.mates || !(spread > 1e-9 * at.xx)) continue;
    at.slope = (at.xy - at.x * at.y / at.count) / spread;
    used += 1;
    shared += at.mates_xx / at.xx;
  }
  std::vector<double> residual(output.size());
  for (std::size_t i = 0; i < output.size(); ++i) {
    const Sums& at = sums[binning.bin_of[i]];
    residual[i] = output[i] - at.y / at.count - at.slope * (binning.offset[i] - at.x / at.count);
  }
  const double whole = lot_variance(output, weights, binning.lot_of).whole();
  if (!(whole > 1e-12 * squares / runs)) return kUndefined;
  return 1 - residual_variance(residual, weights, binning.lot_of, used, shared).whole() / whole;
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
                                          std::span<const double> output, std::size_t bins,
                                          std::vector<std::size_t> lot_of) {
  const Binning binning = make_binning(feature, bins, std::move(lot_of));
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
    sums[{bin, binning.lot_of[i]}] += output[i] - points[bin].mean;
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
