#include "src/cage/mesh/hex8_incompatible.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include "src/cage/solve/elastic_body.hpp"
#include "src/cage/stress/field_recovery.hpp"
#include "tests/support/hex_meshes.hpp"

namespace cagetol {
namespace {

const Material kCubeSteel{206e9, 0.30, 7850};

/// A cube of 2 x 2 x 2 elements whose inner and surface nodes are thrown off the grid.
HexMesh distorted_cube() {
  HexMesh mesh = test::box_mesh({1e-3, 1e-3, 1e-3}, 2, 2, 2);
  for (Eigen::Index n = 0; n < mesh.nodes.cols(); ++n) {
    const double s = static_cast<double>(n);
    mesh.nodes.col(n) +=
        0.08e-3 * Eigen::Vector3d(std::sin(3 * s), std::sin(5 * s + 1), std::cos(7 * s));
  }
  return mesh;
}

/// Every linear displacement field must leave the inner node without force and give its constant
/// stress.
TEST(Hex8Incompatible, PatchTestOnDistortedMesh) {
  const HexMesh mesh = distorted_cube();
  const SparseMatrix stiffness =
      assemble_body(mesh, kCubeSteel).stiffness.selfadjointView<Eigen::Lower>();
  const int inner = 13;
  std::vector<int> all(27);
  for (int n = 0; n < 27; ++n) all[static_cast<std::size_t>(n)] = n;
  for (int mode = 0; mode < 9; ++mode) {
    Eigen::Matrix3d slope = Eigen::Matrix3d::Zero();
    slope(mode / 3, mode % 3) = 1e-3;
    Eigen::VectorXd u(3 * mesh.nodes.cols());
    for (Eigen::Index n = 0; n < mesh.nodes.cols(); ++n)
      u.segment<3>(3 * n) = slope * mesh.nodes.col(n);
    const Eigen::VectorXd force = stiffness * u;
    EXPECT_LT(force.segment<3>(3 * inner).norm(), 1e-11 * kCubeSteel.young * 1e-3 * 1e-6);
    Eigen::Matrix<double, 6, 1> strain;
    strain << slope(0, 0), slope(1, 1), slope(2, 2), slope(0, 1) + slope(1, 0),
        slope(1, 2) + slope(2, 1), slope(2, 0) + slope(0, 2);
    const Eigen::Matrix<double, 6, 1> exact = elasticity(kCubeSteel) * strain;
    const Eigen::MatrixXd stress = nodal_stress(mesh, kCubeSteel, u, all);
    for (int n = 0; n < 27; ++n) {
      EXPECT_LT((stress.middleRows<6>(6 * n) - exact).norm(), 1e-9 * kCubeSteel.young * 1e-3);
    }
  }
}

TEST(Hex8Incompatible, SingleElementHasSixRigidModesAndNoMore) {
  HexMesh mesh = test::box_mesh({1e-3, 2e-3, 1.5e-3}, 1, 1, 1);
  mesh.nodes.col(7) += Eigen::Vector3d(2e-4, -1e-4, 3e-4);
  const Hex8 hex = hex8_stiffness(element_nodes(mesh, mesh.elements[0]), kCubeSteel);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(hex.stiffness)};
  const double largest = solver.eigenvalues()[23];
  EXPECT_LT(std::abs(solver.eigenvalues()[5]), 1e-13 * largest);
  EXPECT_GT(solver.eigenvalues()[6], 1e-3 * largest);
}

TEST(Hex8Incompatible, ConsistentMassSumsToTheVolume) {
  const HexMesh box = test::box_mesh({2e-3, 3e-3, 4e-3}, 2, 1, 3);
  double mass = 0;
  for (const auto& element : box.elements)
    mass += hex8_mass(element_nodes(box, element), 1000).sum();
  EXPECT_NEAR(mass, 1000 * 24e-9, 1e-17);
}

/// Cantilever 50 x 1 x 1 mm, one element through the thickness, against P L^3/(3 E I) with shear.
/// The plain 8-node element is a third too stiff here.
TEST(Hex8Incompatible, ThinBarBends) {
  const double length = 50e-3;
  const double side = 1e-3;
  const HexMesh mesh = test::box_mesh({length, side, side}, 40, 1, 1);
  Material material = kCubeSteel;
  material.poisson = 0;  // beam theory
  const SparseMatrix full = assemble_body(mesh, material).stiffness.selfadjointView<Eigen::Lower>();
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int> place(static_cast<std::size_t>(full.rows()), -1);
  int count = 0;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(full.rows());
  for (Eigen::Index n = 0; n < mesh.nodes.cols(); ++n) {
    if (mesh.nodes(0, n) > length - 1e-9) load[3 * n + 2] = 0.25;
    if (mesh.nodes(0, n) < 1e-9) continue;
    for (int d = 0; d < 3; ++d) place[static_cast<std::size_t>(3 * n + d)] = count++;
  }
  Eigen::VectorXd force(count);
  for (Eigen::Index j = 0; j < full.outerSize(); ++j) {
    const int col = place[static_cast<std::size_t>(j)];
    if (col < 0) continue;
    force[col] = load[j];
    for (SparseMatrix::InnerIterator it(full, j); it; ++it) {
      const int row = place[static_cast<std::size_t>(it.row())];
      if (row >= 0) entries.emplace_back(row, col, it.value());
    }
  }
  SparseMatrix stiffness(count, count);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd u = Eigen::SimplicialLDLT<SparseMatrix>(stiffness).solve(force);
  const double inertia = side * side * side * side / 12;
  const double bending = length * length * length / (3 * material.young * inertia);
  const double shear = length / (5.0 / 6.0 * 0.5 * material.young * side * side);
  EXPECT_NEAR(u.dot(force) / (bending + shear), 1, 0.003);
}

}  // namespace
}  // namespace cagetol
