// Modes and static responses by cyclic symmetry against those of the whole cage's matrices.
#include "src/cage/solve/cyclic_cage.hpp"

#include <gtest/gtest.h>

#include "tests/support/checked_modes.hpp"

namespace cagetol {
namespace {

const Material kCyclicSteel{206e9, 0.30, 7850};

CageMesh mesh_of(long pockets) {
  const CageDimensions cage{.pocket_count = pockets, .pocket_width = pockets == 8 ? 9e-3 : 7.65e-3};
  const auto mesh = make_cage_mesh(
      cage, std::vector<PocketDeviation>(static_cast<std::size_t>(pockets)), mesh_counts(cage, 1));
  return std::get<CageMesh>(mesh);
}

/// Eight pockets have a single harmonic of alternating sign, and one whose normal motion of the
/// bars' middle planes vanishes on one side.
class CyclicCageOf : public testing::TestWithParam<long> {};

TEST_P(CyclicCageOf, HasTheModesOfTheWholeCage) {
  const CageMesh mesh = mesh_of(GetParam());
  const BodyMatrices body = assemble_body(mesh.mesh, kCyclicSteel);
  const HeldFactor factor(body.stiffness, rigid_motions(mesh.mesh.nodes));
  const FreeModes whole = checked_free_modes(mesh.mesh, body, factor, 36);
  const CyclicCage cyclic(mesh, kCyclicSteel);
  const FreeModes modes = cyclic.modes(36);
  ASSERT_EQ(modes.frequency.size(), whole.frequency.size());
  EXPECT_LT((modes.frequency.array() / whole.frequency.array() - 1).abs().maxCoeff(), 1e-9);
  EXPECT_LT((cyclic.mass() - body.mass).norm(), 1e-12 * body.mass.norm());
  const Eigen::MatrixXd inertia = symmetric_product(body.mass, modes.shape);
  const Eigen::MatrixXd gram = modes.shape.transpose() * inertia;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(gram.rows(), gram.cols())).norm(), 1e-9);
  const Eigen::ArrayXd square = (2 * M_PI * modes.frequency.array()).square();
  const Eigen::MatrixXd force = symmetric_product(body.stiffness, modes.shape);
  EXPECT_LT((force - inertia * square.matrix().asDiagonal()).norm(), 1e-6 * force.norm());
}

TEST_P(CyclicCageOf, RespondsToForcesLikeTheWholeCage) {
  const CageMesh mesh = mesh_of(GetParam());
  const BodyMatrices body = assemble_body(mesh.mesh, kCyclicSteel);
  const HeldFactor factor(body.stiffness, rigid_motions(mesh.mesh.nodes));
  const Eigen::MatrixXd rigid = mass_orthonormal(rigid_motions(mesh.mesh.nodes), body.mass);
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(rigid.rows(), 4);
  loads(5, 0) = 1;
  loads(100, 1) = 2;
  loads(loads.rows() - 7, 1) = -1;
  loads.col(2) = Eigen::VectorXd::LinSpaced(loads.rows(), -1, 2);
  loads(mesh.sector_node[0].back() * 3, 3) = 1;  // on the plane between two sectors
  const Eigen::MatrixXd wanted = free_static_response(body, factor, rigid, loads);
  const Eigen::MatrixXd found = CyclicCage(mesh, kCyclicSteel).static_response(loads);
  for (Eigen::Index i = 0; i < loads.cols(); ++i)
    EXPECT_LT((found.col(i) - wanted.col(i)).norm(), 1e-8 * wanted.col(i).norm()) << i;
}

INSTANTIATE_TEST_SUITE_P(Pockets, CyclicCageOf, testing::Values(8L, 13L));

}  // namespace
}  // namespace cagetol
