// Two runs of one study, by two builds or on two nights: has anything changed?
//
// Tested for every quantity: mean, standard deviation, and the quantiles of 5, 50 and 95 %; for the
// limits: joint yield and the yield of each limit, runs without a result failing; and the shares of
// jams and of failed runs. A quantile is tested by the share of runs beyond the quantile of both
// samples together; the standard deviation by the distances of runs from the median of both
// samples, permuted: the variance of a variance says nothing where tails are heavy. Means of
// few runs and of a quantity that hardly ever varies are permuted too. Studies with the same seed
// ran the same cages: these are compared pair by pair.
#pragma once

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

/// Notes what the two have apart; throws Refused with the reason where they are not runs of one
/// study, `despite_keys` notes keys that differ instead.
void require_comparable(const StudyData& before, const StudyData& after, bool despite_keys,
                        std::vector<std::string>& notes);

/// Same seed and design: the same rows are the same cages.
bool same_cages(const StudyData& before, const StudyData& after);

/// Throws Refused with the reason where the two are not runs of one study: another scene, other
/// laws, limits, candidates, design or units. `despite_keys` notes keys that differ instead: what
/// did a change of the scene change?
Comparison compare_studies(const StudyData& before, const StudyData& after, double error_rate,
                           bool despite_keys = false);

}  // namespace cagetol
