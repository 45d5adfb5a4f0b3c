#include "src/cage/stress/field_recovery.hpp"

#include <cmath>

#include "src/cage/mesh/hex8_incompatible.hpp"

namespace cagetol {
namespace {

Eigen::MatrixXd corner_values(const std::array<int, 8>& element, const Eigen::MatrixXd& fields) {
  Eigen::MatrixXd values(24, fields.cols());
  for (int a = 0; a < 8; ++a) {
    values.middleRows<3>(3 * a) = fields.middleRows<3>(3 * element[static_cast<std::size_t>(a)]);
  }
  return values;
}

}  // namespace

Eigen::MatrixXd nodal_stress(const HexMesh& mesh, const Material& material,
                             const Eigen::MatrixXd& fields, const std::vector<int>& nodes) {
  std::vector<int> place(static_cast<std::size_t>(mesh.nodes.cols()), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    place[static_cast<std::size_t>(nodes[i])] = static_cast<int>(i);
  }
  const Eigen::Matrix<double, 6, 6> d = elasticity(material);
  Eigen::MatrixXd stress =
      Eigen::MatrixXd::Zero(6 * static_cast<Eigen::Index>(nodes.size()), fields.cols());
  Eigen::VectorXd meeting = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(nodes.size()));
  for (const auto& element : mesh.elements) {
    bool touches = false;
    for (int node : element) touches = touches || place[static_cast<std::size_t>(node)] >= 0;
    if (!touches) continue;
    const Hex8Nodes corners = element_nodes(mesh, element);
    const auto strain = hex8_corner_strain(corners, hex8_stiffness(corners, material).internal);
    const Eigen::MatrixXd values = corner_values(element, fields);
    for (std::size_t a = 0; a < 8; ++a) {
      const int i = place[static_cast<std::size_t>(element[a])];
      if (i < 0) continue;
      meeting[i] += 1;
      const Eigen::Matrix<double, 6, 24> at_corner = d * strain[a];
      stress.middleRows<6>(6 * i).noalias() += at_corner * values;
    }
  }
  for (Eigen::Index i = 0; i < meeting.size(); ++i) {
    if (meeting[i] > 1) stress.middleRows<6>(6 * i) /= meeting[i];
  }
  return stress;
}

double von_mises(const Eigen::Ref<const Eigen::Matrix<double, 6, 1>>& stress) {
  const double a = stress[0] - stress[1];
  const double b = stress[1] - stress[2];
  const double c = stress[2] - stress[0];
  const double shear = stress.tail<3>().squaredNorm();
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 3 * shear);
}

}  // namespace cagetol
