// Clearances of a roller in the middle of its pocket, and of the cage in the middle of its bearing.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

/// All in metres; negative where the parts overlap.
struct PocketClearances {
  double tangential = 0;  ///< S - D, half of it on each side of the roller
  double axial = 0;       ///< L - L_w, half of it at each end of the roller
  double flange = 0;      ///< axial clearance of the roller between the ring's flanges
  /// Radial play at the bore (0) and the outside (1): radial_play() of pocket_outline.hpp.
  double radial[2] = {0, 0};
  /// Radial, between cage and inner ring (0), cage and outer ring (1).
  double ring[2] = {0, 0};
  double by_diameters[2] = {0, 0};  ///< the same where cage.guide_clearance_mm is not given
};

/// Of pocket `pocket` (from 0) of a scene. The guiding ring's clearance is cage.guide_clearance_mm
/// where that is given.
PocketClearances pocket_clearances(const Scene& scene, long pocket);

/// The smallest `tangential` of all pockets, 0 where one overlaps its roller.
double narrowest_tangential(const Scene& scene);

}  // namespace cagetol
