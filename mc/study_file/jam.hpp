// How many cages jam, by geometry alone: a roller larger than its pocket.
#pragma once

#include <string>
#include <vector>

namespace cagetol {

/// Share of jammed cages over the tolerance of one tolerance dimension, all others at their
/// narrowest.
struct JamCurve {
  std::string key;
  std::vector<double> tolerance_width_mm, share;  ///< narrowest first
};

/// Empty where the study has no candidates, or its file does not say.
struct JamShares {
  std::vector<double> candidate;  ///< in the order of the study's candidates
  std::vector<JamCurve> curves;   ///< in the order of its dimensions
};

}  // namespace cagetol
