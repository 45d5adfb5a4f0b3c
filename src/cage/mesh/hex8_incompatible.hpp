// 8-node hexahedron with incompatible modes (the class of C3D8I): the three bending modes
//   1 - xi_i^2,   i = 1, 2, 3
// that the plain element lacks. Without them a bar one element thick is a third too stiff.
//
// Wilson et al., Incompatible displacement models (1973), with the correction of Taylor, Beresford
// and Wilson, IJNME 10 (1976) 1211, doi 10.1002/nme.1620100602: derivatives of the incompatible
// modes use the Jacobian at the element's centre, scaled by det J0 / det J, so that their integral
// vanishes and every constant stress state passes the patch test on distorted meshes. 2 x 2 x 2
// Gauss points; consistent mass. Isotropic linear elasticity. Stress and strain order: xx, yy, zz,
// xy, yz, zx (engineering shear).
#pragma once

#include <Eigen/Core>
#include <array>

#include "src/cage/mesh/cage_mesh.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

using Hex8Nodes = Eigen::Matrix<double, 3, 8>;
using Hex8Matrix = Eigen::Matrix<double, 24, 24>;
/// Nine internal parameters (mode i, direction d at 3 i + d) per element displacement.
using Hex8Internal = Eigen::Matrix<double, 9, 24>;
/// Derivatives with respect to x, y, z of 8 shape functions and 3 incompatible modes.
using Hex8Derivatives = Eigen::Matrix<double, 3, 11>;

Hex8Nodes element_nodes(const HexMesh& mesh, const std::array<int, 8>& element);

/// Smallest Jacobian determinant of the corners [m^3]; positive for a valid element.
double hex8_smallest_jacobian(const Hex8Nodes& nodes);

/// Elasticity matrix [Pa].
Eigen::Matrix<double, 6, 6> elasticity(const Material& material);

struct Hex8 {
  Hex8Matrix
      stiffness;  ///< incompatible modes eliminated; unknown 3 a + d: corner a, direction d [N/m]
  Hex8Internal internal;  ///< incompatible parameters per corner displacement
};
Hex8 hex8_stiffness(const Hex8Nodes& nodes, const Material& material);

/// Consistent mass between corners, one direction (directions do not couple) [kg].
Eigen::Matrix<double, 8, 8> hex8_mass(const Hex8Nodes& nodes, double density);

/// Local coordinates of corner a.
Eigen::Vector3d hex8_corner(int a);

/// Strain operators at the 8 corners, extrapolated trilinearly from the Gauss points, where the
/// element is most accurate.
std::array<Eigen::Matrix<double, 6, 24>, 8> hex8_corner_strain(const Hex8Nodes& nodes,
                                                               const Hex8Internal& internal);

}  // namespace cagetol
