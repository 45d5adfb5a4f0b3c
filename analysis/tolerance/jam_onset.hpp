// Where jams begin: the tolerance up to which cages fit, and the one whose jams alone miss the
// target.
//
// From the shares that a study file holds (mc/run/jam_shares.hpp), straight lines between their
// tolerances.
#pragma once

#include <optional>

#include "mc/study_file/jam.hpp"

namespace cagetol {

struct JamOnset {
  std::optional<double> free_mm;   ///< widest tolerance at which no cage drawn jams
  std::optional<double> limit_mm;  ///< narrowest tolerance whose jams alone miss the target yield
};

JamOnset jam_onset(const JamCurve& curve, double target_yield);

}  // namespace cagetol
