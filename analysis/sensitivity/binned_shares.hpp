// First-order share of variance by binning (Li & Mahadevan 2016, doi:10.1016/j.ress.2016.04.004).
//
//   S = Var(E[Y | X]) / Var(Y)
//
// It can be estimated from any runs: X is divided into M classes of equal probability, and E[Y |
// X] is a straight line in each class. With class means instead, the scatter of E[Y | X] within
// classes would be lost, and the outer classes of a normal X are wide: at M = 16 the share of Y =
// X would be 0.96. The plain ratio of the explained to the total scatter has a bias of about P/N,
// even if X has no effect, P the parameters of all lines. Epsilon squared (Kelley 1935) corrects
// for it:
//
//   S = 1 - (SSW / (W - P)) / (SST / (W - 1)),   W the number of runs, SSW the scatter around lines
//
// Runs of one lot have the deviation of the lot in common. Both mean squares are then those of
// statistics/lot_variance.hpp: a feature of lots has as many independent values as there are lots.
//
// Its mean is zero for an X without effect; it can be slightly negative. A class of fewer than
// four lots, or of one value of X, has its mean instead of a line. What is curved within a class
// is still lost, so M grows with the number N of independent values: M = sqrt(N) / 2,
// within 4 .. 32.
#pragma once

#include <span>
#include <vector>

#include "analysis/statistics/resampling.hpp"

namespace cagetol {

/// Class of every sample.
struct Binning {
  std::size_t bins = 0;
  std::vector<std::size_t> bin_of;
  std::vector<double> offset;  ///< feature less the mean of its class
  std::vector<std::size_t> lot_of;
  /// Runs of its lot in its class, itself included, and the sum of their offsets.
  struct Mates {
    double runs = 0, offset = 0;
  };
  std::vector<Mates> mates;
};

/// Classes for so many independent values.
std::size_t bin_count(std::size_t values);

/// `bins` classes with equal numbers of samples; equal values are in the same class. 0: bin_count()
/// of the values, those that a lot has several times counted once. No lots: each run has its own.
Binning make_binning(std::span<const double> feature, std::size_t bins = 0,
                     std::vector<std::size_t> lot_of = {});

/// The share from weighted runs, without samples whose output is NaN. NaN if the output does not
/// vary.
double binned_share(const Binning& binning, std::span<const double> output,
                    std::span<const double> weights);

/// The share with its interval. Resamples contain repeated runs, so their shares are too large; the
/// interval is shifted by the mean excess over the estimate.
Estimate binned_share_estimate(const Binning& binning, std::span<const double> output,
                               const Resampling& resampling, double confidence);

/// Mean of the output in each class with its standard error, and the mean feature value of the
/// class. The standard error is that of the sums over lots.
struct ResponsePoint {
  double feature = 0, mean = 0, standard_error = kUndefined;
};
std::vector<ResponsePoint> response_curve(std::span<const double> feature,
                                          std::span<const double> output, std::size_t bins,
                                          std::vector<std::size_t> lot_of = {});

}  // namespace cagetol
