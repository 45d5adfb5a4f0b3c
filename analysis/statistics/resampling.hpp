// Intervals from the runs of a study, depending on its design.
//
// Runs of a lot are dependent, and so are repeated runs of a row. The bootstrap therefore draws
// whole lots with replacement (cluster bootstrap). A Latin hypercube has no independent repeats:
// the bootstrap takes its rows for independent, so that its intervals are too wide, which
// description() says. Designs of former programs have no interval.
//
// A resample is a weight for every sample: the number of times that its lot was drawn. A statistic
// is a function of these weights.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "analysis/study/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

using WeightedStatistic = std::function<double(std::span<const double> weights)>;

/// With fewer lots their scatter says too little about itself.
inline constexpr std::size_t kFewestLots = 8;

enum class IntervalKind { lots, none };

/// Resamples behind an interval where nothing else is said.
inline constexpr std::size_t kUsualResamples = 500;

class Resampling {
 public:
  Resampling(const StudyData& study, std::size_t resamples);

  IntervalKind kind() const { return kind_; }
  /// How intervals are computed, in words for the report.
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
  /// NaN if there is no interval.
  double standard_error(const WeightedStatistic& statistic,
                        std::span<const double> base = {}) const;

 private:
  /// Values for the resamples of `base` that define the statistic; empty if there are too few.
  std::vector<double> resampled(const WeightedStatistic& statistic,
                                std::span<const double> base) const;
  Estimate interval(const WeightedStatistic& statistic, double tail,
                    std::span<const double> base) const;

  IntervalKind kind_ = IntervalKind::none;
  bool latin_ = false;  ///< rows of a Latin hypercube, which the bootstrap takes for independent
  std::size_t lots_ = 0;
  std::string why_none_;  ///< why there are no intervals
  std::vector<std::size_t> lot_of_;
  std::vector<std::vector<double>> weights_;
};

/// True if rows are drawn independently and every row has its own lot, as exact binomial and
/// order-statistic bounds require. Otherwise `why_not` is the reason.
bool independent_runs(const StudyData& study, std::string* why_not = nullptr);

/// True if every row is drawn by the laws of the inputs, as yields require. The rows of a grid are
/// levels chosen by hand. Otherwise `why_not` is the reason.
bool rows_follow_laws(const StudyData& study, std::string* why_not = nullptr);

/// Throws Refused with `what` and the reason unless independent_runs().
void require_independent_runs(const StudyData& study, const std::string& what);

}  // namespace cagetol
