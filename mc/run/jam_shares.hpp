// How many cages of each candidate tolerance jam. Geometry alone decides, no run is needed: it is
// known far better than any yield, and beyond the candidates too.
#pragma once

#include "mc/study/study.hpp"
#include "mc/study_file/jam.hpp"

namespace cagetol {

/// Cages drawn for every share.
inline constexpr long kJamCages = 8192;
/// Where the curves end: this many times the widest candidate.
inline constexpr double kWidestJamTolerance = 2.5;

/// The same cages at every tolerance, drawn with the seed of the study. Empty where
/// `cage.allow_interference` simulates jams.
JamShares jam_shares(const Study& study);

/// Those of the candidates alone, in a fraction of the time.
std::vector<double> candidate_jam_shares(const Study& study);

}  // namespace cagetol
