// Structured hexahedral mesh of a window cage: two side rings joined by Z bars.
//
// Frame of the cage: x along the axis, angle theta from y towards z. The nominal centre of pocket j
// is at theta = 2 pi j / Z. Sector j extends from the middle plane of the bar before pocket j to
// the middle plane of the bar after it. These planes do not move, so a sector depends on the
// deviations of its own pocket only.
//
// Faces of pocket j, in its own frame, turned to 2 pi j / Z + pitch:
//   leading face   u = +S/2 + x gamma
//   trailing face  u = -S/2 + x gamma
//   side ring faces      x = +-L/2
// Fillets between them are cylinders of the corner radius about radial axes.
// u is the tangential offset from the pocket's central radial plane, so bars are wedges.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "src/operation/operating_scene.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// A mesh of 8-node hexahedra. Corners are ordered as in Abaqus, CalculiX and VTK: four around the
/// lower face, then four around the upper face.
struct HexMesh {
  Eigen::Matrix3Xd nodes;  ///< [m]
  std::vector<std::array<int, 8>> elements;
};

/// Dimensions common to all sectors of a cage.
struct CageDimensions {
  long pocket_count = 13;
  double inner_radius = 18.5e-3;   ///< [m]
  double outer_radius = 21.7e-3;   ///< [m]
  double width = 14e-3;            ///< axial [m]
  double pocket_width = 7.65e-3;   ///< S of the undeviated pocket [m]
  double pocket_length = 9.25e-3;  ///< L of the undeviated pocket [m]
  /// Of the pockets' fillets [m]. 0: sharp corners, whose stress belongs to the mesh.
  double corner_radius = 0;
};

/// Deviation of one pocket from the undeviated one.
struct PocketDeviation {
  double width = 0;       ///< S_j - S [m]
  double length = 0;      ///< L_j - L [m]
  double pitch = 0;       ///< dpsi_j, centre of the pocket towards larger theta [rad]
  double squareness = 0;  ///< dgamma_j, faces lean towards larger theta with growing x [rad]
};

/// Numbers of elements.
struct MeshCounts {
  long radial = 3;    ///< through the cage's thickness
  long half_bar = 1;  ///< from a pocket face to the middle of the bar
  long pocket = 8;    ///< across a pocket (side rings only)
  long side = 3;      ///< from a pocket end to the cage's end face
  long length = 8;    ///< along a pocket
};

/// Counts for `density` elements through the thickness. Along bars and across side rings elements
/// are about 1.3 / `density` as long as the narrower of bar and side ring is wide, through half a
/// bar two thirds of that, across the pocket, where the side ring only bends, four thirds. The
/// cage's thickness bounds all from below: they are made for at least half of it in place of 1.3
/// widths.
MeshCounts mesh_counts(const CageDimensions& cage, long density);

enum class CageFaultKind {
  geometry,      ///< the deviations leave no valid cage
  outside_table  ///< a valid cage perhaps, but beyond the deviations the cage table covers
};

/// Why a cage cannot be built. This is an outcome of a sample, not an error of the program.
struct CageFault {
  CageFaultKind kind = CageFaultKind::geometry;
  int pocket = -1;  ///< 0-based
  std::string reason;
};

/// Position of a node or station in its sector, independent of the deviations.
struct SectorPoint {
  double radial = 0;  ///< 0 at the inner, 1 at the outer surface
  double around = 0;  ///< -1, 1: trailing, leading pocket face; -2, 2: middle planes of the bars
  double axial = 0;   ///< -1, 1: pocket ends; -2, 2: end faces of the cage
  /// On the fillet of a pocket corner: 0 where it meets the bar's face, 1 where it meets the end
  /// wall; negative elsewhere.
  double fillet = -1;
};

/// Position in the sector's own frame (nominal pocket centre at theta = 0) [m]. Linear in each
/// deviation, except for the curvature of the cage (second order in deviation / radius). Points of
/// the pocket's outline nearer to a corner than its radius lie on the fillet, the corner itself in
/// the middle of the arc; what they are moved by fades towards the bar's middle plane and the end
/// face.
Eigen::Vector3d sector_position(const CageDimensions& cage, const PocketDeviation& deviation,
                                const SectorPoint& point);

/// Rotates a vector of the frame of sector 0 into that of sector j: turns by 2 pi j / Z about x.
Eigen::Matrix3d sector_rotation(const CageDimensions& cage, long sector);

/// The grid of one sector, the same for all sectors and deviations.
struct SectorGrid {
  MeshCounts counts;
  std::vector<SectorPoint> points;           ///< nodes, both bounding planes included
  std::vector<std::array<int, 8>> elements;  ///< corners are indices into `points`
  std::vector<int> column;                   ///< of each point: 0 ... columns
  long columns = 0;                          ///< elements around one sector
};
SectorGrid make_sector_grid(const MeshCounts& counts);

/// The point at the mirror image of each point about the middle of the pocket.
std::vector<int> mirror_points(const SectorGrid& grid);

/// Mirror image of displacements of the points.
Eigen::MatrixXd mirror_field(const std::vector<int>& mirror, const Eigen::MatrixXd& field);

/// Nodes of a sector for its deviations, in the sector's own frame.
Eigen::Matrix3Xd sector_nodes(const CageDimensions& cage, const PocketDeviation& deviation,
                              const SectorGrid& grid);

/// A whole cage. `sector_node[j][p]` is the mesh node at point p of the grid in sector j.
struct CageMesh {
  CageDimensions cage;
  SectorGrid grid;
  HexMesh mesh;
  std::vector<std::vector<int>> sector_node;
};

/// Impossible geometry, from the dimensions alone: a pocket that breaks through a side ring, into
/// its neighbour, or past the middle of a bar. Empty if the cage is possible.
std::optional<CageFault> cage_fault(const CageDimensions& cage,
                                    const std::vector<PocketDeviation>& deviations);

/// Meshes a deviated cage. Returns a fault if the geometry is impossible or an element is inverted.
std::variant<CageMesh, CageFault> make_cage_mesh(const CageDimensions& cage,
                                                 const std::vector<PocketDeviation>& deviations,
                                                 const MeshCounts& counts);

/// Dimensions of a scene's cage. Its undeviated pocket is the mean of its pockets.
CageDimensions cage_dimensions(const OperatingScene& scene);

/// Deviations of a scene's pockets from the undeviated pocket of `cage`.
std::vector<PocketDeviation> pocket_deviations(const OperatingScene& scene,
                                               const CageDimensions& cage);

}  // namespace cagetol
