// Where jams begin: the tolerance of one jam in a million, and the one whose jams alone miss the
// target.
//
// From the shares that a study file holds (mc/run/jam_shares.hpp), between them straight lines of
// the logarithm of the share.
#pragma once

#include <optional>
#include <string>

#include "mc/study_file/jam.hpp"

namespace cagetol {

/// Tolerance from which on more than `share` of the cages jam; nothing where they are fewer.
std::optional<double> tolerance_of_jams(const JamCurve& curve, double share);

/// Share of cages that jam at a tolerance: at the ends of the curve that of its last tolerance, 0
/// without a curve.
double share_of_jams(const JamCurve& curve, double tolerance_width_mm);

/// "0.57 %" or "0.3 ppm" of cages that jam; of none among so many `draws` the bound at 95 %.
std::string jam_text(double share, double draws);

struct JamOnset {
  std::optional<double> ppm_mm;    ///< widest tolerance at which 1 ppm of the cages jam at most
  std::optional<double> limit_mm;  ///< narrowest tolerance whose jams alone miss the target yield
};

/// Numbers within the curve; where its narrowest tolerance is too wide there is no ppm_mm, and
/// limit_mm is that one.
JamOnset jam_onset(const JamCurve& curve, double target_yield);

}  // namespace cagetol
