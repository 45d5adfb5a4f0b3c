// 20-node element: patch test, mass, stress of a quadratic field, and what it refuses.
#include "src/cage/mesh/hex20.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "src/cage/mesh/hex8_incompatible.hpp"

namespace cagetol {
namespace {

const Material kAnySteel{206e9, 0.30, 7850};

/// A box 2 x 1 x 0.5 m with its corners moved, edges straight.
Hex20Nodes distorted() {
  Hex20Nodes nodes;
  for (int a = 0; a < 20; ++a) {
    const auto& n = hex20_node(a);
    nodes.col(a) << n[0] + 0.1 * n[1] * n[2], 0.5 * n[1] + 0.05 * n[0] * n[2],
        0.25 * n[2] + 0.03 * n[0] * n[1];
  }
  return nodes;
}

TEST(Hex20, ShapesAreOneAtTheirNodeAndSumToOne) {
  for (int a = 0; a < 20; ++a) {
    const auto& n = hex20_node(a);
    const auto shape = hex20_shape({n[0], n[1], n[2]});
    for (int b = 0; b < 20; ++b) EXPECT_NEAR(shape[b], a == b, 1e-14) << a << " " << b;
  }
  EXPECT_NEAR(hex20_shape({0.3, -0.2, 0.7}).sum(), 1, 1e-14);
}

TEST(Hex20, ConstantStrainIsExact) {
  Eigen::Matrix3d slope;
  slope << 1, 2, -3, 0.5, -1, 4, 2, 1, 0.3;
  const Hex20Nodes nodes = distorted();
  Eigen::Matrix<double, 60, 1> u;
  for (int a = 0; a < 20; ++a) u.segment<3>(3 * a) = slope * nodes.col(a);
  Eigen::Matrix<double, 6, 1> strain;
  strain << slope(0, 0), slope(1, 1), slope(2, 2), slope(0, 1) + slope(1, 0),
      slope(1, 2) + slope(2, 1), slope(2, 0) + slope(0, 2);
  for (int a = 0; a < 20; ++a)
    EXPECT_LT((hex20_node_strain(nodes, a) * u - strain).norm(), 1e-10) << a;
  // Energy of the field: strain energy density times the volume, which the mass gives.
  const double volume = hex20_mass(nodes, 1).sum();
  EXPECT_NEAR(u.dot(hex20_stiffness(nodes, kAnySteel) * u) /
                  (volume * strain.dot(elasticity(kAnySteel) * strain)),
              1, 1e-10);
}

TEST(Hex20, RigidMotionsCostNothing) {
  const auto stiffness = hex20_stiffness(distorted(), kAnySteel);
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness).eigenvalues();
  EXPECT_LT(values.head<6>().cwiseAbs().maxCoeff(), 1e-9 * values[59]);
  EXPECT_GT(values[6], 1e-4 * values[59]);  // and nothing else does: no hourglass
}

TEST(Hex20, BendingStressIsExactOnABox) {
  Hex20Nodes nodes;
  for (int a = 0; a < 20; ++a) nodes.col(a) << hex20_node(a)[0], hex20_node(a)[1], hex20_node(a)[2];
  const double nu = kAnySteel.poisson;
  Eigen::Matrix<double, 60, 1> u;  // pure bending: stress E z along x
  for (int a = 0; a < 20; ++a) {
    const double x = nodes(0, a), y = nodes(1, a), z = nodes(2, a);
    u.segment<3>(3 * a) << x * z, -nu * y * z, -(x * x + nu * (z * z - y * y)) / 2;
  }
  for (int a = 0; a < 20; ++a) {
    const Eigen::Matrix<double, 6, 1> stress =
        elasticity(kAnySteel) * hex20_node_strain(nodes, a) * u;
    EXPECT_NEAR(stress[0] / kAnySteel.young, nodes(2, a), 1e-12) << a;
    EXPECT_LT(stress.tail<5>().norm(), 1e-12 * kAnySteel.young) << a;
  }
}

TEST(Hex20, RefusesAnElementTurnedInsideOut) {
  Hex20Nodes nodes = distorted();
  nodes.row(2) *= -1;
  EXPECT_THROW(hex20_stiffness(nodes, kAnySteel), std::domain_error);
}

}  // namespace
}  // namespace cagetol
