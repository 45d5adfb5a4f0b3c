// Upper confidence bounds of the share of a law beyond a limit, from values x_1 ... x_n that are
// all within the limit.
//
// Normal tolerance bound (Hahn & Meeker, Statistical Intervals, 1991, ch. 4): with
//   K = (limit - mean) / s,   z = (limit - mu) / sigma
// sqrt(n) K has the noncentral t law with n - 1 degrees of freedom and noncentrality sqrt(n) z. The
// bound is Q(z_L), where sqrt(n) K is the quantile of level `confidence` of that law at z_L. Holds
// for a normal law only.
//
// Exponential tail bound: let u be the (k + 1)-th value from the limit, k = ceil(n / 4). Beyond u
// the law is taken as exponential:
//   share <= k / n exp(-(limit - u) / theta_U)
//   theta_U = theta 2 k / chi2_{1 - confidence}(2 k),   theta mean of the k excesses over u
// Valid for tails that decrease at least exponentially in the outer quarter;
// SettledLimit.IsSeldomWrong (tests/unit/analysis) tries both bounds on other laws.
#pragma once

#include <span>

namespace cagetol {

/// Normal tolerance bound of the share above `limit`. 1 if a value is above the limit or there are
/// fewer than two values. Without scatter only the number of values counts:
///   1 - (1 - confidence)^(1/n)
double normal_tail_bound(std::span<const double> values, double limit, double confidence);

/// Exponential tail bound of the share above `limit`, with the same special cases.
double exponential_tail_bound(std::span<const double> values, double limit, double confidence);

/// The larger of both bounds.
double tail_bound(std::span<const double> values, double limit, double confidence);

}  // namespace cagetol
