// Which cage table a sample uses. A table is exact for its own undeviated pocket and becomes less
// accurate with the distance from it. A scene therefore has several tables: their undeviated
// pockets form a grid around the pocket of the scene.
#pragma once

#include <compare>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

/// Position in the grid, in steps from the scene's pocket.
struct GridPoint {
  long width = 0;
  long length = 0;
  auto operator<=>(const GridPoint&) const = default;
};

/// The cage of a grid point: the scene's cage `nominal` with all pockets widened and lengthened by
/// the steps of the point.
CageDimensions cage_at(const CageDimensions& nominal, const GridPoint& point);

/// The grid point nearest to the mean pocket of a cage, given by its deviations from `nominal`. The
/// grid ends at the range of the nominal table. An impossible cage gets the nominal point, whose
/// table reports why the cage is impossible.
GridPoint nearest_point(const CageDimensions& nominal,
                        const std::vector<PocketDeviation>& deviations);

}  // namespace cagetol
