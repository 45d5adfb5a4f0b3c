// First-order share of variance by binning (Li & Mahadevan 2016, doi:10.1016/j.ress.2016.04.004).
//
//   S = Var(E[Y | X]) / Var(Y)
//
// It can be estimated from any runs: X is divided into M classes of equal probability, and E[Y | X]
// is the mean of a class. The plain ratio of the scatter between classes to the total scatter has a
// bias of about (M-1)/N, even if X has no effect. Epsilon squared (Kelley 1935) corrects for it:
//
//   S = 1 - (SSW / (W - M)) / (SST / (W - 1)),   W the number of runs
//
// Its mean is zero for an X without effect; it can be slightly negative. Classes lose the scatter
// within a class (a straight line over a uniform X keeps 1 - 1/M^2 of its share), so M grows with
// N: M = sqrt(N), within 4 .. 64.
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

/// `bins` classes with equal numbers of samples; equal values are in the same class. 0:
/// bin_count().
Binning make_binning(std::span<const double> feature, std::size_t bins = 0);

/// The share from weighted runs, without samples whose output is NaN. NaN if the output does not
/// vary.
double binned_share(const Binning& binning, std::span<const double> output,
                    std::span<const double> weights);

/// The share with its interval. Resamples contain repeated runs, so their shares are too large; the
/// interval is shifted by the mean excess over the estimate.
Estimate binned_share_estimate(const Binning& binning, std::span<const double> output,
                               const Resampling& resampling, double confidence);

/// Mean of the output in each class with its standard error, and the mean feature value of the
/// class.
struct ResponsePoint {
  double feature = 0, mean = 0, standard_error = 0;
};
std::vector<ResponsePoint> response_curve(std::span<const double> feature,
                                          std::span<const double> output, std::size_t bins);

}  // namespace cagetol
