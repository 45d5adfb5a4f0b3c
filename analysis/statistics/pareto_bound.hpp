// Upper confidence bound of the share of a law beyond a far limit, extrapolated from the tail of a
// sample.
//
// Above a high threshold u the excesses of nearly any law follow the generalised Pareto law
// (Pickands 1975, doi:10.1214/aos/1176343003). With zeta = k / n, the share of the n values above
// u,
//
//   p = P(X > limit) = zeta (1 + xi d / sigma)^(-1 / xi),   d = limit - u
//
// takes the place of sigma in the likelihood l(p, xi) of the k excesses. The bound is the largest p
// with
//
//   2 (max l - max_xi l(p, xi)) <= z^2,   z the normal quantile of the confidence
//
// (profile likelihood; Coles 2001, An Introduction to Statistical Modeling of Extreme Values,
// ch. 4) among laws that reach the limit with -0.5 <= xi <= 1: above -0.5 the likelihood is regular
// (Smith 1985, doi:10.1093/biomet/72.1.67). Where the sample's excess kurtosis exceeds
// 3 sqrt(24 / n), three standard errors of a normal law's, xi >= 0: samples of heavy tails that end
// by chance without an outlier would have bounds that hold too seldom. The bound is blind to
// whatever has not shown in the sample: a second kind of failure does not move it.
// tests/unit/analysis/pareto_bound_test.cpp tries it on responses of known share.
#pragma once

#include <cstddef>
#include <span>

namespace cagetol {

/// Fewer values tell too little of a tail.
inline constexpr std::size_t kFewestTailValues = 1000;

/// With the largest `threshold_share` of the values above the threshold. 1 where that is less than
/// ten values or the limit lies below the threshold; where these values are all the same,
/// 1 / (1000 n), below which no bound is given.
double pareto_bound(std::span<const double> values, double limit, double threshold_share,
                    double confidence);

/// The largest bound of thresholds that 5, 10, 15 and 20 % and fifty of the values exceed: of many
/// values 5 % reach so far down that normal ones no longer follow the law.
double extrapolated_bound(std::span<const double> values, double limit, double confidence);

}  // namespace cagetol
