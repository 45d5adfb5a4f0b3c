// Intervals from the study's own runs, by the way its rows were chosen.
//
// Runs that share a lot are not independent, and the repeated runs of one row neither: what is
// drawn again, with replacement, are whole lots (cluster bootstrap). A scrambled Sobol' design
// holds R independent scrambles: its statistics are computed per scramble and their scatter gives a
// Student t interval. Grids have no interval: nothing in them is random but the noise.
//
// A resample is a weight for every sample: how often its lot was drawn. A statistic is a function
// of such weights.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

using WeightedStatistic = std::function<double(std::span<const double> weights)>;

enum class IntervalKind { lots, scrambles, none };

class Resampling {
 public:
  Resampling(const StudyData& study, std::size_t resamples);

  IntervalKind kind() const { return kind_; }
  /// How intervals come about, in words for the report.
  std::string description() const;
  std::size_t lots() const { return lots_; }
  std::size_t resamples() const { return weights_.size(); }
  /// Lot of each sample, numbered 0 .. lots()-1 in order of first appearance.
  const std::vector<std::size_t>& lot_of() const { return lot_of_; }
  std::span<const double> weights(std::size_t resample) const { return weights_[resample]; }

  /// Value with unit weights (or `base`) and its two-sided interval at `confidence`.
  Estimate estimate(const WeightedStatistic& statistic, double confidence,
                    std::span<const double> base = {}) const;

  /// One-sided bounds at `confidence` each.
  Estimate one_sided(const WeightedStatistic& statistic, double confidence,
                     std::span<const double> base = {}) const;

  /// Standard error of the value with unit weights (or `base`), from its scatter over resamples.
  /// NaN where there is no interval.
  double standard_error(const WeightedStatistic& statistic,
                        std::span<const double> base = {}) const;

 private:
  /// Over the resamples of `base` that define it; empty where too few do.
  std::vector<double> resampled(const WeightedStatistic& statistic,
                                std::span<const double> base) const;
  Estimate interval(const WeightedStatistic& statistic, double tail,
                    std::span<const double> base) const;

  IntervalKind kind_ = IntervalKind::none;
  std::size_t lots_ = 0;
  std::vector<std::size_t> lot_of_;
  std::vector<std::vector<double>> weights_;
};

/// True where rows are drawn independently and every row has a lot of its own: what exact binomial
/// and order-statistic bounds need. `why_not` then says what stands in the way.
bool independent_runs(const StudyData& study, std::string* why_not = nullptr);

/// Throws Refused with `what` and the reason unless independent_runs().
void require_independent_runs(const StudyData& study, const std::string& what);

}  // namespace cagetol
