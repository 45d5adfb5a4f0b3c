// Stresses of displacement fields at the nodes of a mesh.
//
// A field has one displacement vector per node (3 n + d); several fields are the columns of a
// matrix.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

/// Stress of each field at chosen nodes: rows 6 i + (xx, yy, zz, xy, yz, zx) for node `nodes[i]`.
/// Values are extrapolated from the Gauss points and averaged over the elements at the node [Pa per
/// unit].
Eigen::MatrixXd nodal_stress(const HexMesh& mesh, const Material& material,
                             const Eigen::MatrixXd& fields, const std::vector<int>& nodes);

/// Von Mises stress of six components in the order above.
double von_mises(const Eigen::Ref<const Eigen::Matrix<double, 6, 1>>& stress);

}  // namespace cagetol
