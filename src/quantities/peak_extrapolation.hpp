// Extrapolates the largest value of a window to a longer time, from the largest values of its
// blocks (revolutions of the cage).
//
// Law: block maxima follow the generalised extreme-value distribution (Coles 2001, An Introduction
// to Statistical Modeling of Extreme Values, eq. 3.2), independently of each other,
//
//   G(x) = exp(-(1 + xi (x - mu)/sigma)^(-1/xi))
//
// so that the largest of N blocks has the distribution G^N. Few blocks do not tell xi, which
// decides what a long time brings; no single value is taken for it. mu, log sigma and xi, the
// latter in [-1, 0.5] (bounded likelihood, finite variance), are equally likely beforehand; their
// likelihood given the blocks weighs G^N, and the quantiles of that mixture are the result:
//
//   P(largest of N blocks < x) = sum of w(mu, sigma, xi) G(x; mu, sigma, xi)^N
//
// The N blocks are taken to be others than those seen. Its interval is that of the peak of a single
// run of N revolutions, not of a mean.
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
