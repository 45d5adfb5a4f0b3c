// How many cages of each candidate tolerance jam. Geometry alone decides, no run is needed: it is
// known far better than any yield (jam_model.hpp), and beyond the candidates too.
#pragma once

#include "mc/study/study.hpp"
#include "mc/study_file/jam.hpp"

namespace cagetol {

/// Where the curves end: this many times the widest candidate.
inline constexpr double kWidestJamTolerance = 2.5;

/// The same whatever the study's seed, design and number of samples: one value for all stages of a
/// recommendation. Empty where `cage.allow_interference` simulates jams.
JamShares jam_shares(const Study& study);

}  // namespace cagetol
