// The basis of the flexible cage: displacement fields of the undeviated cage, from which the cage
// of every sample is composed.
//
//   modes        6 rigid motions (unit translations and rotations), the lowest free-free modes, and
//                the residual of the static response to rotation about the axis
//   attachments  per sector: static response to a unit force on each bar station of its pocket,
//                both faces
//   corrections  per sector: static response to the residual forces that the modes leave in a
//                deviating pocket
//
// Each field is orthogonal in stiffness to all fields before it, so the later ones have no effect
// on the undeviated cage.
#pragma once

#include <Eigen/Core>

#include "src/cage/mesh/bar_strip.hpp"
#include "src/cage/mesh/cage_grid.hpp"
#include "src/cage/mesh/cage_stations.hpp"
#include "src/cage/solve/cage_modes.hpp"
#include "src/cage/solve/cyclic_cage.hpp"
#include "src/cage/solve/sector_carry.hpp"
#include "src/cage/solve/sector_share.hpp"
#include "src/cage/solve/sector_turn.hpp"

namespace cagetol {

struct CageTableOptions {
  long density = 4;           ///< of the mesh, see mesh_counts
  GridPoint point = {};       ///< of the table's undeviated pocket
  long basis_modes = 36;      ///< elastic modes of the undeviated cage in the basis
  long corrections = 2;       ///< correction fields per pocket
  long corrected_modes = 16;  ///< lowest elastic modes for which the corrections are chosen
  long reach = 1;             ///< attachments and corrections extend over +-reach sectors
  StripCounts strip = {};     ///< fine mesh for the stress of bars
};

/// Family of an elastic mode, for reports.
struct ModeFamily {
  long waves = 0;          ///< around the circumference
  double axial_share = 0;  ///< fraction of the kinetic energy in motion along x
  bool opposed = false;    ///< the side rings move in opposite directions in the radial plane
};

/// "in-plane 2", "out-of-plane 3", "in-plane 1 opposed".
std::string family_name(const ModeFamily& family);

/// All columns of the basis on sector 0 of the undeviated cage.
struct SectorFields {
  SectorTurn turn;
  Eigen::MatrixXd fields;   ///< on the nodes of the sector
  Eigen::MatrixXd inertia;  ///< modes x columns: acceleration of each in terms of modes
  Eigen::VectorXd turning;  ///< squared spin of the centrifugal load on each
};

struct CageBasis {
  SectorFields sector;
  Eigen::MatrixXd shapes;     ///< modes on all nodes, including the response to rotation
  Eigen::VectorXd frequency;  ///< elastic modes [Hz]
  CageProjection projection;  ///< of the undeviated cage
  std::vector<ModeFamily> family;
};

CageBasis make_cage_basis(const CageMesh& mesh, const Material& material,
                          const CageStations& stations, const PocketDeviation& range,
                          const CyclicCage& cyclic, const FreeModes& modes,
                          const CageTableOptions& options);

/// The y and z coordinates of the nodes, ordered like a displacement. The centrifugal load is
///   (spin)^2 M (this vector)
Eigen::VectorXd arms(const Eigen::Matrix3Xd& nodes);

/// Loads of the seen columns on the nodes of sector 0.
Eigen::MatrixXd seen_loads(const SectorTurn& turn, const CageDimensions& cage,
                           const CageStations& stations, const SectorGrid& grid,
                           const PocketDeviation& deviation);

}  // namespace cagetol
