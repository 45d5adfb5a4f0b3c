#include "analysis/statistics/resampling.hpp"

#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/statistics/order_statistics.hpp"
#include "analysis/study/refused.hpp"
#include "distributions/basics/random_stream.hpp"

namespace cagetol {
namespace {

/// Of resamples that define a statistic.
constexpr std::int64_t kFewestResults = 4;

std::vector<std::size_t> number_lots(const StudyData& study, std::size_t& lots) {
  std::map<std::int64_t, std::size_t> numbers;
  std::vector<std::size_t> lot_of;
  for (const std::int64_t lot : study.lot)
    lot_of.push_back(numbers.try_emplace(lot, numbers.size()).first->second);
  lots = numbers.size();
  return lot_of;
}

}  // namespace

Resampling::Resampling(const StudyData& study, std::size_t resamples) {
  lot_of_ = number_lots(study, lots_);
  const std::string& design = study.design.kind;
  if (design != "random" && design != "lhs") {
    why_none_ = "none: this program knows no interval of this design";
    return;
  }
  if (lots_ < kFewestLots) {
    why_none_ = fmt::format("none: {} lots, fewer than {}, say too little of their scatter", lots_,
                            kFewestLots);
    return;
  }
  kind_ = IntervalKind::lots;
  latin_ = design == "lhs";
  std::vector<double> drawn(lots_);
  for (std::size_t b = 0; b < resamples; ++b) {
    std::fill(drawn.begin(), drawn.end(), 0.0);
    RandomStream stream(static_cast<std::uint64_t>(study.provenance.seed), Purpose::bootstrap, b);
    for (std::size_t i = 0; i < lots_; ++i) drawn[stream.next_index(lots_)] += 1;
    std::vector<double> weights(study.size());
    for (std::size_t i = 0; i < study.size(); ++i) weights[i] = drawn[lot_of_[i]];
    weights_.push_back(std::move(weights));
  }
}

std::string Resampling::description() const {
  if (kind_ == IntervalKind::none) return why_none_;
  return fmt::format(
      "bootstrap: {} times, {} lots are drawn again with replacement; the interval holds the "
      "middle of the results{}",
      weights_.size(), lots_,
      latin_ ? ". It does not see what the Latin hypercube gains: standard errors and intervals "
               "are too wide, those of means by much"
             : "");
}

Estimate Resampling::estimate(const WeightedStatistic& statistic, double confidence,
                              std::span<const double> base) const {
  return interval(statistic, 0.5 * (1 - confidence), base);
}

Estimate Resampling::one_sided(const WeightedStatistic& statistic, double confidence,
                               std::span<const double> base) const {
  return interval(statistic, 1 - confidence, base);
}

Estimate Resampling::interval(const WeightedStatistic& statistic, double tail,
                              std::span<const double> base) const {
  const std::vector<double> ones(base.empty() ? lot_of_.size() : 0, 1.0);
  if (base.empty()) base = ones;
  Estimate estimate;
  estimate.value = statistic(base);
  if (kind_ == IntervalKind::none || std::isnan(estimate.value)) return estimate;
  const std::vector<double> results = resampled(statistic, base);
  if (results.empty()) return estimate;
  const std::vector<double> equal(results.size(), 1.0);
  const auto order = ascending_order(results);
  estimate.lower = weighted_quantile(results, order, equal, tail);
  estimate.upper = weighted_quantile(results, order, equal, 1 - tail);
  return estimate;
}

std::vector<double> Resampling::resampled(const WeightedStatistic& statistic,
                                          std::span<const double> base) const {
  std::vector<double> results, weights;
  for (const auto& resample : weights_) {
    weights = resample;
    for (std::size_t i = 0; i < base.size(); ++i) weights[i] *= base[i];
    const double result = statistic(weights);
    if (!std::isnan(result)) results.push_back(result);
  }
  if (2 * results.size() < weights_.size() || std::ssize(results) < kFewestResults) results.clear();
  return results;
}

double Resampling::standard_error(const WeightedStatistic& statistic,
                                  std::span<const double> base) const {
  const auto results = resampled(statistic, base);
  if (results.empty()) return kUndefined;
  return gsl_stats_sd(results.data(), 1, results.size());
}

bool independent_runs(const StudyData& study, std::string* why_not) {
  std::string reason;
  std::size_t lots = 0;
  number_lots(study, lots);
  if (study.design.kind != "random")
    reason = "the rows of a `" + study.design.kind + "` design are not independent of each other";
  else if (lots < study.size())
    reason =
        "cages of one lot share their lot deviation: the runs are not independent of each other";
  if (why_not != nullptr) *why_not = reason;
  return reason.empty();
}

bool rows_follow_laws(const StudyData& study, std::string* why_not) {
  const std::string& kind = study.design.kind;
  const bool follow = kind == "random" || kind == "lhs" || kind == "sobol";
  if (why_not != nullptr)
    *why_not =
        follow ? "" : "the rows of a `" + kind + "` design do not follow the laws of the inputs";
  return follow;
}

void require_independent_runs(const StudyData& study, const std::string& what) {
  std::string reason;
  if (!independent_runs(study, &reason)) throw Refused(what + " refused: " + reason);
}

}  // namespace cagetol
