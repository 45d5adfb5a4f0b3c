#include "src/cage/solve/elastic_body.hpp"

#include <Eigen/Cholesky>
#include <Eigen/CholmodSupport>
#include <vector>

#include "src/cage/mesh/hex8_incompatible.hpp"
#include "src/cage/solve/unsolved_cage.hpp"

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

Eigen::MatrixXd symmetric_product(const SparseMatrix& lower, const Eigen::MatrixXd& columns) {
  // Rows in one piece of memory: the processor's vectors run over the columns.
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const RowMatrix from = columns;
  RowMatrix product = RowMatrix::Zero(from.rows(), from.cols());
  for (Eigen::Index j = 0; j < lower.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it) {
      product.row(it.row()) += it.value() * from.row(j);
      if (it.row() != j) product.row(j) += it.value() * from.row(it.row());
    }
  return product;
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

Eigen::MatrixXd mass_orthonormal(const Eigen::MatrixXd& motions, const SparseMatrix& mass) {
  const Eigen::MatrixXd product = mass.selfadjointView<Eigen::Lower>() * motions;
  const Eigen::LLT<Eigen::MatrixXd> gram(motions.transpose() * product);
  return gram.matrixL().solve(motions.transpose()).transpose();
}

struct HeldFactor::Cholmod {
  Eigen::CholmodSupernodalLLT<SparseMatrix, Eigen::Lower> llt;
};

HeldFactor::HeldFactor(const SparseMatrix& stiffness, const Eigen::MatrixXd& rigid)
    : cholmod_(std::make_unique<Cholmod>()) {
  SparseMatrix held = stiffness;
  // Springs where the rigid motions move the most and differ the most.
  Eigen::MatrixXd left = rigid;
  for (Eigen::Index i = 0; i < rigid.cols(); ++i) left.col(i).normalize();
  for (Eigen::Index i = 0; i < rigid.cols(); ++i) {
    Eigen::Index at = 0;
    left.rowwise().squaredNorm().maxCoeff(&at);
    held.coeffRef(at, at) *= 2;
    const Eigen::RowVectorXd row = left.row(at).normalized();
    left -= (left * row.transpose()).eval() * row;
  }
  cholmod_->llt.compute(held);
  if (cholmod_->llt.info() != Eigen::Success) {
    throw UnsolvedCage("its stiffness matrix is not positive definite");
  }
}

HeldFactor::~HeldFactor() = default;

Eigen::MatrixXd HeldFactor::solve(const Eigen::Ref<const Eigen::MatrixXd>& right) const {
  return cholmod_->llt.solve(right);
}

Eigen::MatrixXd free_static_response(const BodyMatrices& body, const HeldFactor& factor,
                                     const Eigen::MatrixXd& rigid, const Eigen::MatrixXd& loads) {
  const Eigen::MatrixXd mass_rigid = body.mass.selfadjointView<Eigen::Lower>() * rigid;
  Eigen::MatrixXd rest = loads - mass_rigid * (rigid.transpose() * loads);
  const double norm = rest.norm();
  Eigen::MatrixXd response = factor.solve(rest);
  rest -= symmetric_product(body.stiffness, response);
  response -= rigid * (mass_rigid.transpose() * response);
  if (!(rest.norm() <= 1e-6 * norm)) {
    throw UnsolvedCage("the response to a static force is inaccurate");
  }
  return response;
}

}  // namespace cagetol
