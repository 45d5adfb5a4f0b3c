// How many cages of each candidate tolerance jam. Geometry alone decides, no run is needed: it is
// known far better than any yield, and beyond the candidates too.
//
// Room of a cage is an affine function of its deviations but for a small error delta, both measured
// on the study's own scene:
//   gap_j = base_j + sum_i c_i (s_i X_i + shift_i)      X_i of the lot, or of pocket j
// Where the deviations are independent and those of a gap are all normal but at most one,
//   P(jam) = 1 - E_lot prod_j (1 - P(gap_j <= 0 | lot))
// is integrated: the pockets in closed form, the lot by the trapezoidal rule over its normal
// number. Gaps of different places that share a deviation bound each other's error, which also
// holds what gaps within 2 delta of zero add. Elsewhere, or where that error exceeds 1 ppm (a
// copula, measured values, laws of several kinds, gaps that are not affine), cages are drawn; gaps
// within 4 delta of zero are computed in full.
#pragma once

#include "mc/study/study.hpp"
#include "mc/study_file/jam.hpp"

namespace cagetol {

/// Cages drawn where nothing is integrated.
inline constexpr long kJamCages = 1000000;
/// Where the curves end: this many times the widest candidate.
inline constexpr double kWidestJamTolerance = 2.5;

/// The same whatever the study's seed, design and number of samples: one value for all stages of a
/// recommendation. Empty where `cage.allow_interference` simulates jams, and without scale_lots.
JamShares jam_shares(const Study& study);

/// Of the candidates, from so many drawn cages in any case.
std::vector<double> drawn_jam_shares(const Study& study, long cages);

}  // namespace cagetol
