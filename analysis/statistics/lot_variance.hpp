// Variance of a run around a fit, from runs that share lots.
//
// The residual of a run is that of its lot plus its own, with the variances b and w (one-way random
// effects; Searle, Casella & McCulloch 1992, Variance Components, ch. 3). With H the matrix of the
// fit, W runs, P = tr(H) and R the sum of H over all pairs of runs of one lot, the mean residual
// scatter is
//
//   E[SS] = w (W - P) + b (W - R)
//
// and w is the mean square of residuals within lots. A fit to a feature of lots has R = n P for n
// runs a lot: only lots give it degrees of freedom. With one run a lot w + b = SS / (W - P).
#pragma once

#include <span>

#include "analysis/study/estimate.hpp"

namespace cagetol {

struct LotVariance {
  double in_lots = 0;           ///< w; 0 with one run a lot
  double of_lots = kUndefined;  ///< b, or w + b with one run a lot; NaN if lots are too few

  double whole() const { return in_lots + of_lots; }
};

/// Runs of weight 0 or with a NaN are left out. The runs of a lot, numbered below the number of
/// runs, have one weight, and count as lots of their own as often as it says. `fitted`: P,
/// `fitted_in_lots`: R.
LotVariance residual_variance(std::span<const double> residuals, std::span<const double> weights,
                              std::span<const std::size_t> lot_of, double fitted,
                              double fitted_in_lots);

/// Around the mean.
LotVariance lot_variance(std::span<const double> values, std::span<const double> weights,
                         std::span<const std::size_t> lot_of);

}  // namespace cagetol
