// What a scene tabulates once so that the cage of every sample costs about a millisecond.
//
// A sector's share of the projected stiffness and mass, its contact rows and its stress rows depend
// on the deviations of its own pocket only (sector_carry.hpp). They are fitted by polynomials
// (sector_polynomial.hpp), for one sector: the basis looks the same from all (sector_turn.hpp).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "src/cage/cage_basis.hpp"
#include "src/cage/cage_stations.hpp"
#include "src/cage/sector_turn.hpp"

namespace cagetol {

struct CageTable {
  CageDimensions cage;  ///< with undeviated pockets
  Material material;
  CageStations stations;
  MeshCounts counts;
  PocketDeviation range;  ///< deviations covered
  SectorTurn turn;
  Eigen::VectorXd frequency;       ///< elastic modes of the undeviated cage [Hz]
  std::vector<ModeFamily> family;  ///< of these

  CageProjection undeviated;   ///< projections of the undeviated cage
  Eigen::MatrixXd projection;  ///< change of a packed share (sector_share.hpp) x terms
  Eigen::MatrixXd contact;     ///< (3 contact points, seen columns) x terms
  /// (component, stress station, seen columns but the rigid ones) x terms, the station running
  /// first.
  Eigen::MatrixXf stress;
  /// Undeviated, of attachments of all sectors: (component, stress station) x (sectors 0 ... Z-1,
  /// bar stations of each), seen from sector 0.
  Eigen::MatrixXf attachment_stress;
  std::vector<SectorPoint> stress_points;

  Eigen::MatrixXd gyroscopic;   ///< integral of rho Phi_i . (e_x x Phi_j), modes x modes [kg]
  Eigen::MatrixXd in_plane;     ///< integral of rho of the y, z parts of Phi_i . Phi_j
  Eigen::VectorXd centrifugal;  ///< integral of rho Phi_i . (0, y, z) [kg m]

  Eigen::Index dofs = 0;     ///< unknowns of the finite element model
  double seconds_full = 0;   ///< one full modal solve, assembly to modes, when the table was made
  double seconds_table = 0;  ///< making the table
};

/// Hears which share of a table is made: 0 first, 1 last. May be empty.
using TableProgress = std::function<void(double)>;

/// The table whose undeviated pocket is that of `options.point`, on the grid around the pocket of
/// `cage`. All points have the elements of `cage`, lest stresses at corners step from one to the
/// next. Throws UnsolvedCage where the undeviated cage cannot be meshed or its modes not be found.
CageTable make_cage_table(const CageDimensions& cage, const Material& material,
                          const CageStations& stations, const CageTableOptions& options = {},
                          const TableProgress& progress = {});

/// Sets what follows from the dimensions alone: counts, range, stress points.
void complete_cage_table(CageTable& table, const CageDimensions& cage, const Material& material,
                         const CageStations& stations, const CageTableOptions& options);

}  // namespace cagetol
