// Share of an output's variance that no tolerance can remove. It is measured with repeated runs of
// the same cage from different starts.
#pragma once

#include <span>

#include "analysis/study/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct NoiseShare {
  std::size_t rows = 0;  ///< rows with more than one run, all with a value
  Estimate share;        ///< variance within a row / variance of all first runs, at most 1
  double standard_deviation =
      kUndefined;  ///< of one run about the mean of its cage, in the output's unit
};

/// From all samples of the study, replicates included. Needs at least eight repeated rows. The
/// interval is a bootstrap over rows.
NoiseShare noise_share(const StudyData& study, std::span<const double> output, double confidence,
                       std::size_t resamples);

}  // namespace cagetol
