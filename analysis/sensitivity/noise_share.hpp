// Share of an output's variance that no tolerance can remove: the same cage, run again from another
// start.
#pragma once

#include <span>

#include "analysis/statistics/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct NoiseShare {
  std::size_t rows = 0;  ///< rows that were run more than once, with a value each time
  Estimate share;        ///< variance within a row / variance of all first runs
  double standard_deviation =
      kUndefined;  ///< of one run about the mean of its cage, in the output's unit
};

/// From all samples of the study, replicates included; needs at least eight repeated rows. Interval
/// by drawing rows again.
NoiseShare noise_share(const StudyData& study, std::span<const double> output, double confidence,
                       std::size_t resamples);

}  // namespace cagetol
