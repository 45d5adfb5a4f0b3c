// Surfaces of a cage's mesh laid flat, for drawings of a field on them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "src/cage/cage_mesh.hpp"

namespace cagetol {

/// Quadrilaterals on part of the cage's surface. A mesh node may come several times: each sector
/// brings its own points.
struct CageSurface {
  std::vector<int> node;           ///< of the mesh, one per point
  std::vector<double> across, up;  ///< place of the point on the flat surface
  std::vector<std::array<int, 4>> cells;
};

/// The cylinder at the outer (true) or inner radius: across the angle theta [rad], from -pi/Z on,
/// up the axial position x [m].
CageSurface cylinder_surface(const CageMesh& cage, bool outer);

/// The walls of a pocket one after the other, seen from inside: trailing face along +x, end wall at
/// x > 0 towards the leading face, leading face along -x, end wall at x < 0. Across the way along
/// them [m], up the radius [m].
CageSurface pocket_walls(const CageMesh& cage, const PocketDeviation& deviation, long pocket);

}  // namespace cagetol
