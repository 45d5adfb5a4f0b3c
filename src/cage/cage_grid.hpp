// Which table serves a cage. A table is exact for its undeviated pocket and loses accuracy with the
// distance from it, so cages whose pockets deviate alike have tables of their own: the undeviated
// pockets of a scene's tables are the points of a grid around the scene's pocket.
#pragma once

#include <compare>
#include <vector>

#include "src/cage/cage_mesh.hpp"

namespace cagetol {

/// Steps of the grid from the scene's pocket.
struct GridPoint {
  long width = 0;
  long length = 0;
  auto operator<=>(const GridPoint&) const = default;
};

/// The cage of a grid point: that of the scene, `nominal`, with all pockets wider and longer by a
/// number of steps.
CageDimensions cage_at(const CageDimensions& nominal, const GridPoint& point);

/// The grid point next to the mean of a cage's pockets; deviations are from those of `nominal`. The
/// grid ends at the range of the nominal table. An impossible cage is given the nominal point,
/// whose table says why it is none.
GridPoint nearest_point(const CageDimensions& nominal,
                        const std::vector<PocketDeviation>& deviations);

}  // namespace cagetol
