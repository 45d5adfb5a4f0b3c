// Displacement fields of the undeviated cage from which the cage of every sample is composed.
//
//   modes        6 rigid motions (unit translations and rotations), the lowest free-free modes, and
//                last what these leave out of the static response to turning about the axis
//   attachments  per sector: static response to a unit force on each bar station of its pocket,
//                both faces
//   corrections  per sector: static response to the forces by which a deviating pocket upsets the
//                modes
// Each holds no part of those before it (residual: orthogonal in stiffness), so on the undeviated
// cage the later ones change nothing.
#pragma once

#include <Eigen/Core>

#include "src/cage/cage_grid.hpp"
#include "src/cage/cage_modes.hpp"
#include "src/cage/cage_stations.hpp"
#include "src/cage/sector_carry.hpp"
#include "src/cage/sector_share.hpp"
#include "src/cage/sector_turn.hpp"

namespace cagetol {

struct CageTableOptions {
  long density = 4;           ///< of the mesh, see mesh_counts
  GridPoint point = {};       ///< of the table's undeviated pocket
  long basis_modes = 36;      ///< elastic modes of the undeviated cage in the basis
  long corrections = 2;       ///< correction fields per pocket
  long corrected_modes = 16;  ///< lowest elastic modes for which the corrections are chosen
  long reach = 1;             ///< sectors within which attachments and corrections are felt
};

/// What kind of mode an elastic mode is, for reports.
struct ModeFamily {
  long waves = 0;          ///< around the circumference
  double axial_share = 0;  ///< of the kinetic energy that moves along x
  bool opposed = false;    ///< the side rings move oppositely in the radial plane
};

/// "in-plane 2", "out-of-plane 3", "in-plane 1 opposed".
std::string family_name(const ModeFamily& family);

struct CageBasis {
  SectorTurn turn;
  Eigen::MatrixXd shapes;  ///< modes on all nodes, the response to turning among them
  Eigen::MatrixXd seen;    ///< seen columns on the nodes of sector 0
  /// Attachments of all sectors on the nodes of sector 0: sectors 0 ... Z-1, each with all of its
  /// bar stations.
  Eigen::MatrixXd attachments;
  Eigen::MatrixXd inertia;    ///< drive of the seen columns, see FieldDrive
  Eigen::VectorXd turning;    ///< square of the spin whose centrifugal load drives them besides
  Eigen::VectorXd frequency;  ///< elastic modes [Hz]
  CageProjection projection;  ///< of the undeviated cage
  std::vector<ModeFamily> family;
};

CageBasis make_cage_basis(const CageMesh& mesh, const Material& material,
                          const CageStations& stations, const PocketDeviation& range,
                          const BodyMatrices& body, const ShiftedFactor& factor,
                          const FreeModes& modes, const CageTableOptions& options);

/// The y and z coordinates of nodes, in the order of a displacement: centrifugal load is the mass
/// matrix times this times the square of the spin.
Eigen::VectorXd arms(const Eigen::Matrix3Xd& nodes);

/// Forces on the nodes of sector 0 that belong to the seen columns.
Eigen::MatrixXd seen_loads(const SectorTurn& turn, const CageDimensions& cage,
                           const CageStations& stations, const SectorGrid& grid,
                           const PocketDeviation& deviation);

}  // namespace cagetol
