// A grid study with formulas in place of a bearing: what responses must find is known.
#pragma once

#include "analysis/study/study_data.hpp"

namespace cagetol {

/// Five lengths from -0.25 to +0.25 mm, once with the ring aligned and once misaligned by 2 mrad,
/// `replicates` runs of each with shared starts. Quantities, n standard normal:
///   slip      2 - 4 length / mm + 0.1 n where misaligned; 2 + its start's n else, whatever the
///   length orbit     5 + n stress    no values
/// One run (misaligned, longest, replicate 1) failed.
StudyData make_synthetic_grid(std::int64_t replicates = 16);

}  // namespace cagetol
