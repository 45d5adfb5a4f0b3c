// Room between a cage and what must fit it: its rollers and the rings.
#pragma once

#include <array>
#include <vector>

#include "src/operation/operating_scene.hpp"

namespace cagetol {

/// Where a cage may fail to fit: width and length of a pocket, its lips at the bore and at the
/// outside; the inner and the outer ring.
inline constexpr std::size_t kGapPlaces = 6;

/// Of each place [m]: one number for each pocket or for the ring; empty where nothing can jam
/// there. A cage fits where all are > 0: find_jam() and a seized cage are the contrary.
///   width, length   S - D and L - L_w
///   lips            distance of a lip's rounding from the roller in the middle of its pocket
///   rings           radial clearance; of scenes in motion
using CageGaps = std::array<std::vector<double>, kGapPlaces>;
CageGaps cage_gaps(const OperatingScene& scene);

}  // namespace cagetol
