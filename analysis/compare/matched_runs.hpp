// Pairs of runs of the same cages from two sweeps. The effect of the cage cancels in the
// differences.
#pragma once

#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct MatchedRuns {
  std::string quantity, unit;
  std::vector<double> reference, values;  ///< one element per pair; NaN: no value
};

/// Pairs of the first runs of each row, for every quantity that both sweeps have. A row that only
/// the reference has is paired with NaN.
std::vector<MatchedRuns> matched_runs(const StudyData& reference, const StudyData& runs);

/// True if cages share lots. They are dependent then, and standard errors over runs are too small.
bool share_lots(const StudyData& study);

}  // namespace cagetol
