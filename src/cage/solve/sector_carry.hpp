// Carries displacement fields of the undeviated cage over to a sector whose pocket deviates.
//
// The middle planes of the bars do not move when a pocket deviates; a carried field keeps its
// displacement there. Inside the sector it is in equilibrium with its loads (inertia of a mode,
// load of an attachment) on the moved nodes. Rigid motions have no loads and stay exact.
// Extrapolating the fields to the moved nodes by their gradients is three times less accurate,
// because the strain is concentrated at the corners of the pocket and moves with them.
#pragma once

#include <Eigen/Core>

#include "src/cage/mesh/cage_stations.hpp"
#include "src/cage/solve/elastic_body.hpp"

namespace cagetol {

/// Loads of the fields inside a sector: M fields inertia + loads.
struct FieldDrive {
  Eigen::MatrixXd inertia;  ///< fields x fields: for a mode its eigenvalue on the diagonal
  Eigen::MatrixXd loads;    ///< forces on the nodes of the sector
};

/// True for points on the bars' middle planes.
inline bool on_middle_plane(const SectorGrid& grid, std::size_t point) {
  return grid.column[point] == 0 || grid.column[point] == grid.columns;
}

/// Carries `fields` of the undeviated sector over to the sector with matrices `body`. Each of
/// `passes` takes the inertia from the previous pass and reduces the error by
///   (frequency / lowest frequency of the sector held at its planes)^2
Eigen::MatrixXd carry_fields(const SectorGrid& grid, const BodyMatrices& body,
                             const Eigen::MatrixXd& fields, const FieldDrive& drive,
                             int passes = 2);

/// Unit forces on the bar stations of the pocket, in the tangential direction (normal to its
/// faces), as forces on the nodes of the sector. Columns: trailing face, then leading face.
Eigen::MatrixXd bar_loads(const CageDimensions& cage, const CageStations& stations,
                          const SectorGrid& grid, const PocketDeviation& deviation);

}  // namespace cagetol
