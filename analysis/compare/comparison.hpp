// Compares two runs of one study, by two builds or on two nights, and tests every statistic for
// change.
//
// Statistics of every quantity: mean, standard deviation, quantiles of 5, 50 and 95 %. Statistics
// of the limits: joint yield and yield of each limit, where runs without a result fail. Also the
// shares of jammed and of failed runs.
//
// A quantile is tested by the share of runs beyond the quantile of both samples together. A
// standard deviation is tested by permuting the distances from the median of both samples, because
// the variance of a variance is meaningless for heavy tails. Means of few runs, and of quantities
// that rarely vary, are tested by permutation too. Studies with the same seed have the same cages
// and are compared pair by pair.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct StatisticChange {
  std::string quantity, unit, statistic;
  double before = 0, after = 0;
  double p_value = 1, adjusted_p_value = 1;  ///< after Holm
  bool changed = false;
};

struct Comparison {
  std::vector<StatisticChange> statistics;  ///< smallest p-value first
  bool paired = false;
  double error_rate = 0.01;  ///< probability of any false alarm
  std::vector<std::string> notes;
  bool same() const;
};

/// As `compare --json` and history.json have it.
nlohmann::ordered_json to_json(const StatisticChange& change);

/// Notes the differences of the two files. Throws Refused with the reason if they are not runs of
/// one study; with `despite_keys`, keys that differ are noted instead.
void require_comparable(const StudyData& before, const StudyData& after, bool despite_keys,
                        std::vector<std::string>& notes);

/// True if seed and design are equal, so that equal rows are the same cages.
bool same_cages(const StudyData& before, const StudyData& after);

/// Throws Refused with the reason if the two are not runs of one study: different scene, laws,
/// limits, candidates, design or units. `despite_keys` notes keys that differ instead, to compare
/// runs before and after a change of the scene.
Comparison compare_studies(const StudyData& before, const StudyData& after, double error_rate,
                           bool despite_keys = false);

}  // namespace cagetol
