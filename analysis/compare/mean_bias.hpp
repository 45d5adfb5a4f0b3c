// Does another way to run the same cages - a tolerance, a method, a model - shift the mean of a
// quantity by as much as a study of so many samples can tell? Differences of the runs of one cage,
// pair by pair, so that what the cage does to both cancels.
#pragma once

#include <string>
#include <vector>

#include "analysis/statistics/paired_difference.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct MeanBias {
  std::string quantity, unit;
  PairedDifference pairs;  ///< second less first, the reference; 95 % interval
  double study_error = 0;  ///< standard error of the study's mean: the reference's scatter over
                           ///< sqrt(samples)
  double bias = 0;         ///< [study errors]
  double error = 0;        ///< standard error of the bias [study errors]
  double upper_limit = 0;  ///< of |bias|: |bias| + 1.96 errors (Student's t) [study errors]

  bool small() const { return upper_limit < 1; }
  /// Even the lower limit of |bias| is above one: shown to be off.
  bool large() const { return 2 * (bias < 0 ? -bias : bias) - upper_limit > 1; }
};

/// One for each quantity of `reference` that scatters, by more than a millionth of its mean, and
/// has at least two pairs. Pairs are first runs of the same row.
std::vector<MeanBias> mean_biases(const StudyData& reference, const StudyData& runs,
                                  double study_samples);

/// Cages of one lot depend on each other: errors of means would be too small.
bool share_lots(const StudyData& study);

}  // namespace cagetol
