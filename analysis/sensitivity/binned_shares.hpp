// First-order share of variance by binning (Li & Mahadevan 2016, doi:10.1016/j.ress.2016.04.004).
//
//   S = Var(E[Y | X]) / Var(Y),  estimated from any runs: X is cut into M classes of equal
//   probability, E[Y | X] is the mean of a class.
// The plain ratio of the scatter between classes to the whole is too large by about (M-1)/N even
// when X does nothing. Used here is the ratio corrected for it (epsilon squared, Kelley 1935):
//   S = 1 - (SSW / (W - M)) / (SST / (W - 1)),   W the number of runs,
// which is zero on average for an X that does nothing, and can be slightly negative. Cutting X
// loses the scatter inside a class (a straight line over a uniform X keeps 1 - 1/M^2 of its share),
// so M grows with N: M = sqrt(N), within 4 .. 64.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/resampling.hpp"

namespace cagetol {

/// Class of every sample.
struct Binning {
  std::size_t bins = 0;
  std::vector<std::size_t> bin_of;
};

std::size_t bin_count(std::size_t runs);

/// `bins` classes holding equal numbers of samples; equal values never part. 0: bin_count().
Binning make_binning(std::span<const double> feature, std::size_t bins = 0);

/// The share for weighted runs; samples whose output is NaN are left out. NaN when the output does
/// not vary.
double binned_share(const Binning& binning, std::span<const double> output,
                    std::span<const double> weights);

/// The share with its interval. A resample repeats runs, which makes its share too large: the
/// interval is moved by the mean excess of the resamples over the estimate.
Estimate binned_share_estimate(const Binning& binning, std::span<const double> output,
                               const Resampling& resampling, double confidence);

/// Mean of the output in each class, with the standard error of that mean, over a class's mean
/// feature value.
struct ResponsePoint {
  double feature = 0, mean = 0, standard_error = 0;
};
std::vector<ResponsePoint> response_curve(std::span<const double> feature,
                                          std::span<const double> output, std::size_t bins);

}  // namespace cagetol
