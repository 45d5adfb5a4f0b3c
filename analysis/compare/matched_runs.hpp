// Runs of the same cages by two sweeps, side by side: what a cage does to both cancels in their
// differences.
#pragma once

#include <string>
#include <vector>

#include "analysis/study/study_data.hpp"

namespace cagetol {

struct MatchedRuns {
  std::string quantity, unit;
  std::vector<double> reference, values;  ///< one element for each pair; NaN: no value on that side
};

/// First runs of the same row, for every quantity of both. A row that only the reference has stands
/// there with NaN beside it.
std::vector<MatchedRuns> matched_runs(const StudyData& reference, const StudyData& runs);

/// Whether cages share lots and so depend on each other: errors of means over runs are too small
/// then.
bool share_lots(const StudyData& study);

}  // namespace cagetol
