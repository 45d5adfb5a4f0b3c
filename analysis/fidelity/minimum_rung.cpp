#include "analysis/fidelity/minimum_rung.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/paired_difference.hpp"

namespace cagetol {
namespace {

std::vector<double> values_with_partner(const std::vector<double>& values,
                                        const std::vector<double>& partner) {
  std::vector<double> kept;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!std::isnan(values[k]) && !std::isnan(partner[k])) kept.push_back(values[k]);
  return kept;
}

double correlation_of(const std::vector<double>& x, const std::vector<double>& y) {
  const auto a = values_with_partner(x, y), b = values_with_partner(y, x);
  if (a.size() < 3) return kUndefined;
  return gsl_stats_correlation(a.data(), 1, b.data(), 1, a.size());  // NaN without scatter
}

/// An interval shrinks with the square root of the pairs.
double pairs_until(double pairs, double half_width, double target) {
  if (half_width == 0) return pairs;
  return target > 0 ? std::ceil(pairs * std::pow(half_width / target, 2)) : kUndefined;
}

double allowed_share(const LadderRule& rule) {
  return allowed_wrong_share(rule.budget_share, rule.target_yield, rule.study_samples,
                             rule.candidates);
}

double wrong_share(const std::vector<double>& values, const std::vector<double>& reference,
                   std::span<const Limit> limits, const LadderRule& rule) {
  double share = kUndefined;
  for (const Limit& limit : limits)
    share = std::fmax(share, settled_limit(values, reference, limit, rule.confidence).wrong_share);
  return share;
}

RungShift judged(const std::vector<double>& values, const std::vector<double>& reference,
                 double budget, const LadderRule& rule, std::span<const Limit> limits) {
  const PairedDifference paired = paired_difference(reference, values, rule.confidence);
  RungShift rung;
  rung.shift = paired.difference;
  rung.pairs = paired.pairs;
  rung.correlation = correlation_of(values, reference);
  std::size_t wanted = 0;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    wanted += !std::isnan(reference[k]);
    rung.lost += !std::isnan(reference[k]) && std::isnan(values[k]);
  }
  if (static_cast<double>(rung.lost) > rule.lost_share * static_cast<double>(wanted)) {
    rung.verdict = RungVerdict::unusable;
    return rung;
  }
  if (rung.pairs < 2) return rung;
  const double size = std::abs(rung.shift.value), half = rung.shift.upper - rung.shift.value;
  rung.upper_limit = size + half;
  rung.pairs_needed = pairs_until(static_cast<double>(rung.pairs), half, budget);
  rung.wrong_share = wrong_share(values, reference, limits, rule);
  if (rung.upper_limit <= budget)
    rung.verdict = RungVerdict::adequate;
  else if (rung.wrong_share <= allowed_share(rule))
    rung.verdict = RungVerdict::settled;
  else if (size - half > budget)
    rung.verdict = RungVerdict::biased;
  return rung;
}

}  // namespace

const char* rung_verdict_name(RungVerdict verdict) {
  constexpr const char* kNames[] = {"adequate", "settled", "biased", "unresolved", "unusable"};
  return kNames[static_cast<int>(verdict)];
}

bool will_do(RungVerdict verdict) {
  return verdict == RungVerdict::adequate || verdict == RungVerdict::settled;
}

QuantityLadder minimum_rung(std::span<const std::vector<double>> values, const LadderRule& rule,
                            std::span<const Limit> limits) {
  QuantityLadder ladder;
  if (!limits.empty()) ladder.allowed_wrong_share = allowed_share(rule);
  const std::vector<double>& reference = values.back();
  const auto known = values_with_partner(reference, reference);
  if (known.size() >= 2) {
    ladder.mean = gsl_stats_mean(known.data(), 1, known.size());
    ladder.deviation = gsl_stats_sd(known.data(), 1, known.size());
    ladder.budget = rule.budget_share * ladder.deviation / std::sqrt(rule.study_samples);
  }
  bool open = std::isnan(ladder.budget);  // whether some rung may yet turn out to be adequate
  for (const auto& rung : values.first(values.size() - 1)) {
    ladder.rungs.push_back(judged(rung, reference, ladder.budget, rule, limits));
    const RungVerdict verdict = ladder.rungs.back().verdict;
    open = open || verdict == RungVerdict::unresolved;
    if (will_do(verdict) && !ladder.minimum) ladder.minimum = ladder.rungs.size() - 1;
  }
  RungShift top;
  top.pairs = known.size();
  if (!known.empty()) top.shift = {0, 0, 0};
  top.upper_limit = 0;
  top.wrong_share = wrong_share(reference, reference, limits, rule);
  top.correlation = 1;
  top.verdict = RungVerdict::adequate;
  ladder.rungs.push_back(top);
  if (!ladder.minimum && !open) ladder.minimum = values.size() - 1;
  return ladder;
}

bool leaves_limit_open(const QuantityLadder& quantity) {
  return !(quantity.rungs.back().wrong_share <= quantity.allowed_wrong_share);
}

bool is_out_of_reach(const RungShift& rung, const LadderRule& rule) {
  return !will_do(rung.verdict) && rung.pairs_needed > rule.study_samples;
}

std::size_t minimum_rung_for_all(std::span<const QuantityLadder> quantities) {
  const std::size_t top = quantities.front().rungs.size() - 1;
  for (std::size_t r = 0; r < top; ++r)
    if (std::all_of(quantities.begin(), quantities.end(), [r](const QuantityLadder& quantity) {
          return will_do(quantity.rungs[r].verdict);
        }))
      return r;
  return top;
}

}  // namespace cagetol
