#include "src/cage/elastic_body.hpp"

#include <Eigen/Cholesky>
#include <Eigen/CholmodSupport>
#include <cmath>
#include <vector>

#include "src/cage/hex8_incompatible.hpp"
#include "src/cage/unsolved_cage.hpp"

namespace cagetol {

BodyMatrices assemble_body(const HexMesh& mesh, const Material& material) {
  using Triplet = Eigen::Triplet<double>;
  std::vector<Triplet> stiffness;
  std::vector<Triplet> mass;
  stiffness.reserve(300 * mesh.elements.size());
  mass.reserve(108 * mesh.elements.size());
  for (const auto& element : mesh.elements) {
    const Hex8Nodes nodes = element_nodes(mesh, element);
    const Hex8 hex = hex8_stiffness(nodes, material);
    const auto m = hex8_mass(nodes, material.density);
    for (int b = 0; b < 8; ++b) {
      for (int a = 0; a < 8; ++a) {
        const int row = 3 * element[static_cast<std::size_t>(a)];
        const int col = 3 * element[static_cast<std::size_t>(b)];
        if (row < col) continue;
        for (int e = 0; e < 3; ++e) {
          for (int d = row == col ? e : 0; d < 3; ++d) {
            stiffness.emplace_back(row + d, col + e, hex.stiffness(3 * a + d, 3 * b + e));
          }
          mass.emplace_back(row + e, col + e, m(a, b));
        }
      }
    }
  }
  const Eigen::Index size = 3 * mesh.nodes.cols();
  BodyMatrices body{SparseMatrix(size, size), SparseMatrix(size, size)};
  body.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  body.mass.setFromTriplets(mass.begin(), mass.end());
  return body;
}

RigidMotions rigid_motions(const Eigen::Matrix3Xd& nodes) {
  RigidMotions motions = RigidMotions::Zero(3 * nodes.cols(), 6);
  for (Eigen::Index n = 0; n < nodes.cols(); ++n) {
    const Eigen::Vector3d x = nodes.col(n);
    motions.block<3, 3>(3 * n, 0).setIdentity();
    motions.block<3, 3>(3 * n, 3) << 0, x[2], -x[1], -x[2], 0, x[0], x[1], -x[0], 0;
  }
  return motions;
}

MassProperties mass_properties(const Eigen::Matrix<double, 6, 6>& rigid_mass) {
  MassProperties properties;
  properties.mass = rigid_mass.topLeftCorner<3, 3>().trace() / 3;
  // Momentum of a rotation omega is m omega x c.
  const Eigen::Matrix3d first = rigid_mass.topRightCorner<3, 3>() / properties.mass;
  properties.centre << 0.5 * (first(1, 2) - first(2, 1)), 0.5 * (first(2, 0) - first(0, 2)),
      0.5 * (first(0, 1) - first(1, 0));
  const Eigen::Vector3d& c = properties.centre;
  properties.inertia =
      rigid_mass.bottomRightCorner<3, 3>() -
      properties.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
  return properties;
}

RigidMotions mass_orthonormal(const RigidMotions& motions, const SparseMatrix& mass) {
  const Eigen::Matrix<double, 6, 6> gram =
      motions.transpose() * (mass.selfadjointView<Eigen::Lower>() * motions);
  const Eigen::Matrix<double, 6, 6> lower = gram.llt().matrixL();
  return lower.triangularView<Eigen::Lower>().solve(motions.transpose()).transpose();
}

struct ShiftedFactor::Cholmod {
  Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> llt;
};

ShiftedFactor::ShiftedFactor(const BodyMatrices& body, double shift)
    : cholmod_(std::make_unique<Cholmod>()), shift_(shift) {
  const SparseMatrix shifted = body.stiffness + shift * body.mass;
  cholmod_->llt.compute(shifted);
  if (cholmod_->llt.info() != Eigen::Success) {
    throw UnsolvedCage("its stiffness matrix is not positive definite");
  }
}

ShiftedFactor::~ShiftedFactor() = default;

Eigen::MatrixXd ShiftedFactor::solve(const Eigen::Ref<const Eigen::MatrixXd>& right) const {
  return cholmod_->llt.solve(right);
}

double ring_shift(const HexMesh& mesh, const BodyMatrices& body) {
  Eigen::VectorXd oval(3 * mesh.nodes.cols());
  for (Eigen::Index n = 0; n < mesh.nodes.cols(); ++n) {
    const double theta = std::atan2(mesh.nodes(2, n), mesh.nodes(1, n));
    const double radial = std::cos(2 * theta);
    const double tangential = -0.5 * std::sin(2 * theta);
    oval.segment<3>(3 * n) << 0, radial * std::cos(theta) - tangential * std::sin(theta),
        radial * std::sin(theta) + tangential * std::cos(theta);
  }
  const double stiffness = oval.dot(body.stiffness.selfadjointView<Eigen::Lower>() * oval);
  const double mass = oval.dot(body.mass.selfadjointView<Eigen::Lower>() * oval);
  return 0.002 * stiffness / mass;
}

Eigen::MatrixXd free_static_response(const BodyMatrices& body, const ShiftedFactor& factor,
                                     const RigidMotions& rigid_orthonormal,
                                     const Eigen::MatrixXd& loads) {
  const auto& rigid = rigid_orthonormal;
  const auto mass = body.mass.selfadjointView<Eigen::Lower>();
  const auto stiffness = body.stiffness.selfadjointView<Eigen::Lower>();
  const RigidMotions mass_rigid = mass * rigid;
  const Eigen::MatrixXd balanced = loads - mass_rigid * (rigid.transpose() * loads);
  Eigen::MatrixXd response = Eigen::MatrixXd::Zero(loads.rows(), loads.cols());
  Eigen::MatrixXd residual = balanced;
  // A sweep leaves shift / (shift + lowest eigenvalue) of the residual: little of a stiff ring's,
  // most of it where slender bars are far softer than the ring that the shift is chosen for.
  constexpr int stiff = 60, most = 3000;
  double norm = residual.norm(), before = 0;
  const double target = 1e-9 * norm;
  for (int sweep = 0; sweep < most && norm > target; ++sweep) {
    if (sweep > stiff && norm > 0.995 * before) break;
    Eigen::MatrixXd step = factor.solve(residual);
    step -= rigid * (mass_rigid.transpose() * step);
    response += step;
    residual = balanced - stiffness * response;
    before = norm;
    norm = residual.norm();
  }
  if (!(norm <= 1e-6 * balanced.norm())) {
    throw UnsolvedCage("the response to a static force does not converge");
  }
  return response;
}

}  // namespace cagetol
