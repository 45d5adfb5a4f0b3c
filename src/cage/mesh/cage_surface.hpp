// Surfaces of a cage's mesh unrolled to a plane, for drawings of a field.
#pragma once

#include <array>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

/// Quadrilaterals on a part of the cage's surface. A mesh node may occur several times, because
/// each sector has its own points.
struct CageSurface {
  std::vector<int> node;           ///< of the mesh, one per point
  std::vector<double> across, up;  ///< position of the point in the plane
  std::vector<std::array<int, 4>> cells;
};

/// The cylinder at the outer (true) or inner radius. `across`: angle theta from -pi/Z on [rad];
/// `up`: axial position x [m].
CageSurface cylinder_surface(const CageMesh& cage, bool outer);

/// The walls of a pocket in sequence, seen from inside: trailing face along +x, side ring face at x
/// > 0 towards the leading face, leading face along -x, side ring face at x < 0. `across`: distance
/// along the walls [m]; `up`: radius [m].
CageSurface pocket_walls(const CageMesh& cage, const PocketDeviation& deviation, long pocket);

}  // namespace cagetol
