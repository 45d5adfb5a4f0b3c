// Displacement fields of the undeviated cage carried to a sector whose pocket deviates.
//
// The middle planes of the bars do not move when a pocket deviates: there a carried field keeps its
// displacement. Inside the sector it is in equilibrium, on the moved nodes, with the forces that
// drive it (the inertia of a mode, the load of an attachment). Rigid motions, which nothing drives,
// stay exact. Extending fields to the moved nodes by their own gradient instead is three times less
// accurate: the strain is concentrated at the pocket's corners and moves with them.
#pragma once

#include <Eigen/Core>

#include "src/cage/cage_stations.hpp"
#include "src/cage/elastic_body.hpp"

namespace cagetol {

/// What drives fields inside a sector: M fields inertia + loads.
struct FieldDrive {
  Eigen::MatrixXd inertia;  ///< fields x fields: for a mode its eigenvalue on the diagonal
  Eigen::MatrixXd loads;    ///< forces on the nodes of the sector
};

/// True for points on the bars' middle planes.
inline bool on_middle_plane(const SectorGrid& grid, std::size_t point) {
  return grid.column[point] == 0 || grid.column[point] == grid.columns;
}

/// `fields` on the undeviated sector carried to the sector with matrices `body`. Each of `passes`
/// takes the inertia from the pass before; the error shrinks by (frequency / lowest frequency of
/// the sector held at its planes)^2 each time.
Eigen::MatrixXd carry_fields(const SectorGrid& grid, const BodyMatrices& body,
                             const Eigen::MatrixXd& fields, const FieldDrive& drive,
                             int passes = 2);

/// Unit forces on the bar stations of the pocket, along its tangent (normal to its faces), as
/// forces on the nodes of the sector; columns: trailing face, then leading face.
Eigen::MatrixXd bar_loads(const CageDimensions& cage, const CageStations& stations,
                          const SectorGrid& grid, const PocketDeviation& deviation);

}  // namespace cagetol
