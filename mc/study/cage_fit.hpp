// Whether a drawn cage fits: geometry alone decides, no run is needed.
#pragma once

#include "mc/study/study.hpp"
#include "src/operation/cage_gaps.hpp"

namespace cagetol {

/// Of a scene of the study in operation, the least room at any of its operating points.
CageGaps gaps_in_service(const Study& study, const Scene& scene);

inline constexpr double kSmallestEffect = 1e-13;  ///< of an input on a gap [m]

/// What each gap of the first pocket gains by a unit of an input [m].
using GapSlopes = std::array<double, kGapPlaces>;
GapSlopes gap_slopes(const Study& study, const UncertainInput& input);

/// Whether all gaps are > 0, or `cage.allow_interference` simulates what does not fit.
bool cage_fits(const Study& study, const Scene& scene);

}  // namespace cagetol
