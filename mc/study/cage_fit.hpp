// Whether a drawn cage fits: geometry alone decides, no run is needed.
#pragma once

#include "mc/study/study.hpp"
#include "src/operation/cage_gaps.hpp"

namespace cagetol {

/// Of a scene of the study in operation, the least room at any of its operating points.
CageGaps gaps_in_service(const Study& study, const Scene& scene);

/// Whether all of that is > 0, or `cage.allow_interference` simulates what does not fit.
bool cage_fits(const Study& study, const Scene& scene);

}  // namespace cagetol
