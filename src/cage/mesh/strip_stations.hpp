// Where the stress of a bar is watched on its fine mesh, and how a roller loads that mesh.
#pragma once

#include <vector>

#include "src/cage/mesh/bar_strip.hpp"
#include "src/cage/mesh/cage_stations.hpp"

namespace cagetol {

/// Points of the strip at which stress is watched, and their places on the leading face.
struct StripStations {
  std::vector<int> node;
  std::vector<SectorPoint> place;
};
StripStations strip_stations(const CageDimensions& cage, const CageStations& stations,
                             const BarStrip& strip);

/// Unit force in the direction of `tangent` on the strip's face, along the line of a bar station
/// and spread radially, as nodal forces. `nodes` is the strip with its pocket's deviation, in any
/// frame that is turned about x.
Eigen::VectorXd strip_line_load(const CageDimensions& cage, const CageStations& stations,
                                const PocketDeviation& deviation, const BarStrip& strip,
                                const Eigen::Matrix3Xd& nodes, const Eigen::Vector3d& tangent,
                                std::size_t station);

}  // namespace cagetol
