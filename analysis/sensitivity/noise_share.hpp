// Share of an output's variance that no tolerance can remove. It is measured with repeated runs of
// the same cage from different starts.
//
// With s the share and n_i the runs of row i, the mean of the row has the variance (whole variance)
// (1 - s + s / n_i). Wald (1940, doi:10.1214/aoms/1177731946; Searle, Casella & McCulloch 1992,
// Variance Components, sec. 3.6) weighs the means by its inverse,
//
//   u_i = n_i s / (s + n_i (1 - s)),   H(s) = sum_i u_i (mean_i - mean)^2 / (rows - 1) / s_w^2
//
// H(s) of the true share follows F with rows - 1 and sum_i (n_i - 1) degrees of freedom, exactly
// for normal scatter; it grows with s. The interval is where H(s) lies between quantiles of F. Rows
// of common lots have fewer degrees of freedom, (rows - 1) / (1 + (rows a lot - 1) r^2) for their
// correlation r (Satterthwaite).
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

/// From all samples of the study, replicates included. Needs at least eight repeated rows.
NoiseShare noise_share(const StudyData& study, std::span<const double> output, double confidence);

}  // namespace cagetol
