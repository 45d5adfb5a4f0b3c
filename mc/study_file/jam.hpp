// How many cages jam, by geometry alone: a roller larger than its pocket, lips that pinch it, or a
// ring that holds the cage.
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

/// Share of a tolerance's width by which JamShares::off_centre lies beside the middle.
inline constexpr double kOffCentre = 0.05;

/// Empty where the study has no candidates, or its file does not say.
struct JamShares {
  std::vector<double> candidate;  ///< in the order of the study's candidates
  std::vector<double> error;      ///< of these: standard error of draws, bound of an integral
  double draws = 0;               ///< cages drawn for each share; 0: integrated
  /// What a candidate's share becomes, by candidate and dimension, if that dimension's mean lies
  /// kOffCentre of its tolerance beside the middle, or if all of its variance is among the pockets
  /// of a cage, or all from cage to cage; the same share where it has but one of these parts.
  std::vector<double> off_centre, pockets_alone, lots_alone;
  std::vector<JamCurve> curves;  ///< in the order of its dimensions
};

}  // namespace cagetol
