#include "analysis/statistics/yield.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/binomial_bounds.hpp"

namespace cagetol {
namespace {

constexpr double kFewFailures = 5;

std::vector<double> indicator(std::span<const Judgement> judgements, bool unknown_passes) {
  std::vector<double> passes(judgements.size());
  for (std::size_t i = 0; i < passes.size(); ++i)
    passes[i] = judgements[i] == Judgement::meets ||
                (unknown_passes && judgements[i] == Judgement::unknown);
  return passes;
}

double weighted_share(std::span<const double> passes, std::span<const double> weights) {
  double sum = 0, passing = 0;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    sum += weights[i];
    passing += weights[i] * passes[i];
  }
  return sum > 0 ? passing / sum : kUndefined;
}

/// Sums over the lots of w and of w (pass - share).
struct LotSums {
  std::vector<double> weight, residual;
};

LotSums lot_sums(std::span<const double> passes, std::span<const double> weights, double share,
                 const Resampling& resampling) {
  LotSums sums{std::vector<double>(resampling.lots()), std::vector<double>(resampling.lots())};
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const std::size_t lot = resampling.lot_of()[i];
    sums.weight[lot] += weights[i];
    sums.residual[lot] += weights[i] * (passes[i] - share);
  }
  return sums;
}

/// n* of Korn and Graubard.
double effective_trials(std::span<const double> passes, std::span<const double> weights,
                        double share, const Resampling& resampling) {
  const LotSums sums = lot_sums(passes, weights, share, resampling);
  const double ess = effective_sample_size(sums.weight);
  double total = 0, variance = 0;
  for (const double weight : sums.weight) total += weight;
  for (const double residual : sums.residual) variance += residual * residual;
  const auto lots = static_cast<double>(resampling.lots());
  variance *= lots / (lots - 1) / (total * total);
  if (!(variance > 0) || share == 1) return ess;  // 1: up to rounding, where misses weigh nothing
  const double trials = std::min(share * (1 - share) / variance, lots);
  return (1 - share) * ess < kFewFailures ? std::min(trials, ess) : trials;
}

}  // namespace

double effective_sample_size(std::span<const double> weights) {
  double sum = 0, squares = 0;
  for (const double weight : weights) {
    sum += weight;
    squares += weight * weight;
  }
  return squares > 0 ? sum * sum / squares : 0;
}

Yield estimate_yield(const StudyData& runs, std::span<const Judgement> judgements,
                     std::span<const double> weights, const Resampling& resampling,
                     double confidence) {
  Yield yield;
  yield.runs = static_cast<double>(judgements.size());
  yield.ess = effective_sample_size(weights);
  for (const Judgement judgement : judgements) {
    yield.missing_runs += judgement == Judgement::misses;
    yield.unknown_runs += judgement == Judgement::unknown;
  }
  if (judgements.empty() || yield.ess <= 0) {
    yield.if_unknown_fail = yield.if_unknown_pass = kUndefined;
    yield.method = "no runs";
    return yield;
  }
  if (!rows_follow_laws(runs, &yield.method)) {
    yield.if_unknown_fail = yield.if_unknown_pass = kUndefined;
    yield.lower_bound = yield.upper_bound = kUndefined;
    return yield;
  }
  const auto low = indicator(judgements, false), high = indicator(judgements, true);
  yield.if_unknown_fail = weighted_share(low, weights);
  yield.if_unknown_pass = weighted_share(high, weights);

  const bool equal = std::all_of(weights.begin(), weights.end(),
                                 [&](double weight) { return weight == weights[0]; });
  if (equal && independent_runs(runs)) {
    yield.lower_bound =
        clopper_pearson_lower(yield.if_unknown_fail * yield.runs, yield.runs, confidence);
    yield.upper_bound =
        clopper_pearson_upper(yield.if_unknown_pass * yield.runs, yield.runs, confidence);
    yield.method = "Clopper-Pearson, exact";
    return yield;
  }
  const double low_trials = effective_trials(low, weights, yield.if_unknown_fail, resampling);
  const double high_trials = effective_trials(high, weights, yield.if_unknown_pass, resampling);
  yield.lower_bound =
      clopper_pearson_lower(yield.if_unknown_fail * low_trials, low_trials, confidence);
  yield.upper_bound =
      clopper_pearson_upper(yield.if_unknown_pass * high_trials, high_trials, confidence);
  yield.method = "Clopper-Pearson with the effective number of runs";
  if (resampling.kind() == IntervalKind::none) return yield;
  const auto share = [](const std::vector<double>& passes) {
    return
        [&passes](std::span<const double> resampled) { return weighted_share(passes, resampled); };
  };
  const Estimate low_boot = resampling.one_sided(share(low), confidence, weights);
  const Estimate high_boot = resampling.one_sided(share(high), confidence, weights);
  if (!std::isnan(low_boot.lower)) yield.lower_bound = std::min(yield.lower_bound, low_boot.lower);
  if (!std::isnan(high_boot.upper))
    yield.upper_bound = std::max(yield.upper_bound, high_boot.upper);
  yield.lower_bound = std::max(yield.lower_bound, 0.0);
  yield.upper_bound = std::min(yield.upper_bound, 1.0);
  yield.method += " and bootstrap over lots, the wider of both";
  return yield;
}

}  // namespace cagetol
