// Extrapolates the largest value of a window to a longer time, from the largest values of its
// blocks (revolutions of the cage).
//
// Law: block maxima follow the generalised extreme-value distribution (Coles 2001, An Introduction
// to Statistical Modeling of Extreme Values, eq. 3.2),
//
//   G(x) = exp(-(1 + xi (x - mu)/sigma)^(-1/xi))
//
// so that the largest of N independent blocks has the distribution G^N. Successive maxima may be
// alike: their normal scores z = Phi^-1(G(x)) are a first-order autoregression of correlation r
// (Joe 2014, Dependence Modeling with Copulas, sec. 3.14). Correlated blocks tell less of the law,
// and N of them have the largest value of fewer, from P(z' > u | z > u) of far u = Phi^-1(1 - 1/N):
//
//   N' = N erf(a u / sqrt(2)) / erf(u / sqrt(2)),   a = sqrt((1 - r) / (1 + r))
//
// Few blocks do not tell xi, which decides what a long time brings, nor r; no single value is taken
// for them. mu, log sigma, xi in [-1, 0.5] (bounded likelihood, finite variance) and r in [0, 0.9]
// are equally likely beforehand; their likelihood given the blocks weighs G^N', and the quantiles
// of that mixture are the result:
//
//   P(largest of N blocks < x) = sum of w(mu, sigma, xi, r) G(x; mu, sigma, xi)^N'(r)
//
// with the mean N' of each G. The N blocks are taken to be others than those seen. Its interval is
// that of the peak of a single run of N revolutions, not of a mean.
#pragma once

#include <cstddef>
#include <vector>

namespace cagetol {

inline constexpr std::size_t kMinimumBlocks = 5;

struct ExtrapolatedPeak {
  double median, low, high;  ///< quantiles 0.5, 0.025, 0.975
};

/// Of the largest of `blocks` blocks, whose number may be a fraction above 0. NaN for fewer than
/// kMinimumBlocks maxima. Maxima that are all the same are their own extrapolation.
ExtrapolatedPeak extrapolate_peak(const std::vector<double>& maxima, double blocks);

}  // namespace cagetol
