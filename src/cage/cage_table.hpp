// What a scene tabulates once so that the cage of every sample costs about a millisecond.
//
// Basis of displacement fields of the undeviated cage: 6 rigid motions, the lowest free-free modes, and per
// bar station the static response to a tangential unit force on that bar (attachment). On a deviated cage
// every basis field is carried to the moved nodes with its own gradient,
//   Phi(X + dX) = Phi(X) + grad Phi . dX,
// so rigid motions stay exact. A sector's share of the projected stiffness and mass, its contact rows and its
// stress rows then depend on the deviations of its own pocket only and are fitted by polynomials.
//
// The undeviated cage looks the same from every sector: the basis seen from sector k is the basis seen from
// sector 0 times a rotation R^k, which turns mode pairs by k times an angle and shifts the bars' attachments
// by k. So one sector is tabulated for all.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "src/cage/cage_stations.hpp"

namespace cagetol {

struct CageTableOptions {
  long density = 4;       ///< of the mesh, see mesh_counts
  long basis_modes = 40;  ///< elastic modes of the undeviated cage in the basis
};

struct CageTable {
  CageDimensions cage;
  Material material;
  CageStations stations;
  MeshCounts counts;
  PocketDeviation range;  ///< deviations covered

  Eigen::Index modes = 0;      ///< rigid motions and elastic modes in the basis
  Eigen::Index columns = 0;    ///< modes and attachments
  Eigen::VectorXi partner;     ///< per mode: the other of its pair, itself for a single one
  Eigen::VectorXd angle;       ///< per mode: turn of the pair per sector, signed so that first has +, second - [rad]
  Eigen::VectorXd frequency;   ///< elastic modes of the undeviated cage [Hz]
  Eigen::VectorXi harmonic;    ///< per elastic mode: waves around the circumference, modulo the sector count
  Eigen::VectorXd axial_share; ///< per elastic mode: share of the kinetic energy moving along x
  Eigen::VectorXd mirror;      ///< per elastic mode: +1 equal, -1 opposite at x and -x (radial motion)

  Eigen::MatrixXd projection;  ///< (stiffness, then mass; packed lower triangles) x terms
  Eigen::MatrixXd contact;     ///< (3 contact points, columns) x terms
  Eigen::MatrixXd stress;      ///< (6 stress stations, columns) x terms
  std::vector<SectorPoint> stress_points;

  Eigen::MatrixXd gyroscopic;   ///< integral of rho Phi_i . (e_x x Phi_j), modes x modes [kg]
  Eigen::MatrixXd in_plane;     ///< integral of rho of the y, z parts of Phi_i . Phi_j
  Eigen::VectorXd centrifugal;  ///< integral of rho Phi_i . (0, y, z) [kg m]

  double dofs = 0;           ///< unknowns of the finite element model
  double seconds_full = 0;   ///< one full modal solve, assembly to modes, when the table was made
  double seconds_table = 0;  ///< making the table
};

/// Throws std::runtime_error where the undeviated cage itself cannot be meshed.
CageTable make_cage_table(const CageDimensions& cage, const Material& material,
                          const CageStations& stations, const CageTableOptions& options);

/// Sets what follows from the dimensions alone: counts, range, stress points.
void complete_cage_table(CageTable& table, const CageDimensions& cage, const Material& material,
                         const CageStations& stations, const CageTableOptions& options);

/// columns of `matrix` as seen from sector k: matrix R^k.
Eigen::MatrixXd turn_columns(const CageTable& table, const Eigen::MatrixXd& matrix, long k);

/// Identifies everything a table depends on; the name of its cache file.
std::string cage_table_key(const CageDimensions& cage, const Material& material,
                           const CageStations& stations, const CageTableOptions& options);

/// The table from `folder`/cage-<key>.bin where that file exists and is whole, else made and written there.
CageTable cached_cage_table(const std::filesystem::path& folder, const CageDimensions& cage,
                            const Material& material, const CageStations& stations,
                            const CageTableOptions& options);

}  // namespace cagetol
