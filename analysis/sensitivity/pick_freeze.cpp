#include "analysis/sensitivity/pick_freeze.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/study/design_blocks.hpp"
#include "analysis/study/refused.hpp"
#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

/// Outputs of one base: A, B, AB_0, AB_1, ...
using Base = std::vector<double>;

/// "KEY:lot" or "KEY:pocket" -> group of its columns.
std::string group_column(const StudyDesign& design, const std::string& input) {
  for (std::size_t c = 0; c < design.columns.size(); ++c)
    if (design.columns[c] == input || design.columns[c].starts_with(input + "["))
      return design.groups[c];
  return input;
}

void require_independent_groups(const StudyData& runs) {
  for (const Correlation& pair : runs.plan.correlations)
    if (pair.rho != 0 &&
        group_column(runs.design, pair.first) != group_column(runs.design, pair.second))
      throw Refused(
          "pick-freeze indices refused: " + pair.first + " and " + pair.second +
          " are correlated but belong to different groups; correlated inputs must share one");
}

std::vector<Base> complete_bases(const StudyData& runs, std::span<const double> output,
                                 std::size_t rows_per_base) {
  std::map<std::int64_t, Base> bases;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto base = runs.row[i] / static_cast<std::int64_t>(rows_per_base);
    const auto block =
        static_cast<std::size_t>(runs.row[i] % static_cast<std::int64_t>(rows_per_base));
    bases.try_emplace(base, Base(rows_per_base, kUndefined)).first->second[block] = output[i];
  }
  std::vector<Base> complete;
  for (auto& [number, base] : bases) {
    bool defined = true;
    for (const double y : base) defined = defined && !std::isnan(y);
    if (defined) complete.push_back(std::move(base));
  }
  return complete;
}

struct Pair {
  double first_order, total;
};

/// Shares of the group in block `block`, each base counted as often as `times` says.
Pair shares(const std::vector<Base>& bases, std::span<const double> times, std::size_t block,
            double noise_share) {
  double count = 0, sum_b = 0, sum_ab = 0, sum_a = 0, squares = 0, total = 0, with_ab = 0,
         with_a = 0;
  for (std::size_t i = 0; i < bases.size(); ++i) {
    const double a = bases[i][0], b = bases[i][1], ab = bases[i][block], w = times[i];
    count += w;
    sum_a += w * a;
    sum_b += w * b;
    sum_ab += w * ab;
    squares += w * (b * b + ab * ab);
    total += w * (a - ab) * (a - ab);
    with_ab += w * b * ab;
    with_a += w * b * a;
  }
  const double variance = squares / (2 * count) - std::pow((sum_b + sum_ab) / (2 * count), 2);
  if (!(variance > 0)) return {kUndefined, kUndefined};
  const double raw = total / (2 * count * variance), factor = std::clamp(1 - raw, 0.0, 1.0);
  // The means of A, B and AB differ by chance: products are taken around them.
  const double first = with_ab - factor * with_a - sum_b * (sum_ab - factor * sum_a) / count;
  return {first / count / variance, raw - noise_share};
}

/// A shift of the output changes nothing but the digits that are lost.
void centre(std::vector<Base>& bases) {
  double mean = 0, count = 0;
  for (const Base& base : bases)
    for (const double y : base) mean += y, count += 1;
  for (Base& base : bases)
    for (double& y : base) y -= mean / count;
}

void set_interval(Estimate& estimate, const std::vector<double>& results, double confidence) {
  const std::vector<double> equal(results.size(), 1.0);
  const auto order = ascending_order(results);
  estimate.lower = weighted_quantile(results, order, equal, 0.5 * (1 - confidence));
  estimate.upper = weighted_quantile(results, order, equal, 0.5 * (1 + confidence));
}

}  // namespace

std::vector<GroupShares> pick_freeze_shares(const StudyData& runs, std::span<const double> output,
                                            double noise_share, double confidence,
                                            std::size_t resamples) {
  if (runs.design.kind != "pick-freeze")
    throw Refused("pick-freeze indices need a pick-freeze design, this is `" + runs.design.kind +
                  "`");
  require_independent_groups(runs);
  const DesignBlocks blocks = design_blocks(runs);
  auto bases = complete_bases(runs, output, blocks.rows_per_base);
  centre(bases);
  const std::vector<double> once(bases.size(), 1.0);
  std::vector<GroupShares> all;
  for (std::size_t g = 0; g < blocks.groups.size(); ++g) {
    const bool noise = blocks.groups[g] == "noise";
    const double correction = noise ? 0 : noise_share;
    GroupShares group{blocks.groups[g], {}, {}};
    const Pair value = shares(bases, once, 2 + g, correction);
    group.first_order.value = value.first_order;
    group.total.value = value.total;
    std::vector<double> first, total, times(bases.size());
    for (std::size_t b = 0; b < resamples && bases.size() > 1; ++b) {
      RandomStream stream(static_cast<std::uint64_t>(runs.provenance.seed), Purpose::bootstrap, b,
                          stream_address("pick-freeze"));
      std::fill(times.begin(), times.end(), 0.0);
      for (std::size_t i = 0; i < bases.size(); ++i) times[stream.next_index(bases.size())] += 1;
      const Pair pair = shares(bases, times, 2 + g, correction);
      first.push_back(pair.first_order);
      total.push_back(pair.total);
    }
    set_interval(group.first_order, first, confidence);
    set_interval(group.total, total, confidence);
    all.push_back(std::move(group));
  }
  return all;
}

}  // namespace cagetol
