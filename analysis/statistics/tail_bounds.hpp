// Upper confidence bounds of the share of a law beyond a limit, from a few values x_1 ... x_n none
// of which is beyond it.
//
// Normal tolerance bound (Hahn & Meeker, Statistical Intervals, 1991, ch. 4): with
//   K = (limit - mean) / s,   z = (limit - mu) / sigma
// sqrt(n) K has the noncentral t law with n - 1 degrees of freedom and noncentrality sqrt(n) z. The
// bound is Q(z_L), where sqrt(n) K is the quantile of level `confidence` of that law at z_L. Holds
// for a normal law only.
//
// Exponential tail bound: beyond u, the (k + 1)-th value from the limit, k = ceil(n / 4), the law
// is taken as exponential with the mean excess theta,
//   share <= k / n exp(-(limit - u) / theta_U),  theta_U = theta 2 k / chi2_{1 - confidence}(2 k),
// theta: mean of the k excesses over u. Holds for tails that fall at least as fast as an
// exponential beyond the outer quarter. Both are measured on other laws in tests/ACCURACY.md.
#pragma once

#include <span>

namespace cagetol {

/// Of the share above `limit`. 1 where a value is above it or there are fewer than two; without
/// scatter only the number of values counts: 1 - (1 - confidence)^(1/n).
double normal_tail_bound(std::span<const double> values, double limit, double confidence);

/// Likewise.
double exponential_tail_bound(std::span<const double> values, double limit, double confidence);

/// The larger of both.
double tail_bound(std::span<const double> values, double limit, double confidence);

}  // namespace cagetol
