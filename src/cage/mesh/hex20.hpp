// 20-node hexahedron (the class of C3D20), for stress at curved surfaces.
//
// Quadratic serendipity shape functions. The stiffness is integrated on 3 x 3 x 3 Gauss points: on
// 2 x 2 x 2, flat elements under a line of force leave hourglass stress ten times the true one.
// Stress is taken from the 2 x 2 x 2 points, where it is most accurate, and extrapolated to the
// nodes. Nodes are ordered as in Abaqus and CalculiX: eight corners as in HexMesh, then the middles
// of the edges 1-2, 2-3, 3-4, 4-1, 5-6, 6-7, 7-8, 8-5, 1-5, 2-6, 3-7, 4-8. Stress and strain order:
// xx, yy, zz, xy, yz, zx (engineering shear).
#pragma once

#include <Eigen/Core>
#include <array>

#include "src/scene/scene.hpp"

namespace cagetol {

using Hex20Nodes = Eigen::Matrix<double, 3, 20>;
using Hex20Strain = Eigen::Matrix<double, 6, 60>;

/// Local coordinates of node a, each -1, 0 or 1.
const std::array<double, 3>& hex20_node(int a);

/// Values of the shape functions at local coordinates xi.
Eigen::Matrix<double, 20, 1> hex20_shape(const Eigen::Vector3d& xi);

/// Stiffness, unknown 3 a + d: node a, direction d [N/m]. Throws std::domain_error if a Gauss point
/// lies where the element is turned inside out.
Eigen::Matrix<double, 60, 60> hex20_stiffness(const Hex20Nodes& nodes, const Material& material);

/// Consistent mass between nodes, one direction [kg].
Eigen::Matrix<double, 20, 20> hex20_mass(const Hex20Nodes& nodes, double density);

/// Strain on the 60 displacements at node a, extrapolated trilinearly from the Gauss points.
Hex20Strain hex20_node_strain(const Hex20Nodes& nodes, int a);

}  // namespace cagetol
