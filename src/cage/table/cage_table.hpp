// The table of a flexible cage, made once per scene. With it the cage of a sample takes about a
// millisecond.
//
// The share of a sector in the projected stiffness and mass, its contact rows and its stress rows
// depend on the deviations of its own pocket only (sector_carry.hpp). They are fitted by
// polynomials (sector_polynomial.hpp), once for all sectors, because the basis looks the same from
// each of them (sector_turn.hpp).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "src/cage/mesh/cage_stations.hpp"
#include "src/cage/solve/cage_basis.hpp"
#include "src/cage/solve/sector_turn.hpp"

namespace cagetol {

struct CageTable {
  CageDimensions cage;  ///< with undeviated pockets
  Material material;
  CageStations stations;
  MeshCounts counts;
  BarStrip strip;         ///< fine mesh for the stress of bars; corner radius 0: none
  PocketDeviation range;  ///< largest deviations of the fit
  SectorTurn turn;
  Eigen::VectorXd frequency;       ///< elastic modes of the undeviated cage [Hz]
  std::vector<ModeFamily> family;  ///< of these

  CageProjection undeviated;   ///< projections of the undeviated cage
  Eigen::MatrixXd projection;  ///< change of a packed share (sector_share.hpp) x terms
  Eigen::MatrixXd contact;     ///< (3 contact points, seen columns) x terms
  /// (component, stress station, seen columns without the rigid ones) x terms; the station index
  /// runs fastest.
  Eigen::MatrixXf stress;
  /// Stress of the attachments of all sectors in sector 0 of the undeviated cage: (component,
  /// stress station) x (sectors 0 ... Z-1, bar stations of each).
  Eigen::MatrixXf attachment_stress;
  std::vector<SectorPoint> stress_points;

  Eigen::MatrixXd gyroscopic;   ///< integral of rho Phi_i . (e_x x Phi_j), modes x modes [kg]
  Eigen::MatrixXd in_plane;     ///< integral of rho of the y, z parts of Phi_i . Phi_j
  Eigen::VectorXd centrifugal;  ///< integral of rho Phi_i . (0, y, z) [kg m]

  Eigen::Index dofs = 0;     ///< unknowns of the finite element model
  double seconds_table = 0;  ///< making the table
};

/// Called with the fraction of a table that is done, from 0 to 1. May be empty.
using TableProgress = std::function<void(double)>;

/// The table for the pocket at `options.point` of the grid around the pocket of `cage`. All points
/// use the element counts of `cage`, so that stresses at corners do not jump from point to point.
/// Throws UnsolvedCage if the undeviated cage cannot be meshed or its modes are not found.
CageTable make_cage_table(const CageDimensions& cage, const Material& material,
                          const CageStations& stations, const CageTableOptions& options = {},
                          const TableProgress& progress = {});

/// Sets counts, range and stress points, which follow from the dimensions alone.
void complete_cage_table(CageTable& table, const CageDimensions& cage, const Material& material,
                         const CageStations& stations, const CageTableOptions& options);

}  // namespace cagetol
