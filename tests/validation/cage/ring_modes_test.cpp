// Free ring of Code_Aster SDLS109: mean radius 0.369 m, thickness 0.048 m, width 0.05 m, E 185 GPa,
// nu 0.3, rho 7800: in-plane pairs 210.55 and 587.92 Hz, out-of-plane pairs 205.89 and 588.88 Hz.
#include <gtest/gtest.h>

#include "src/cage/solve/cage_modes.hpp"
#include "tests/support/checked_modes.hpp"
#include "tests/support/hex_meshes.hpp"

namespace cagetol {
namespace {

TEST(RingModes, CodeAsterSdls109) {
  const HexMesh ring = test::ring_mesh(0.345, 0.393, 0.05, 7, 96, 7);
  const BodyMatrices body = assemble_body(ring, {185e9, 0.3, 7800});
  const HeldFactor factor(body.stiffness, rigid_motions(ring.nodes));
  const FreeModes modes = checked_free_modes(ring, body, factor, 8);
  ASSERT_EQ(modes.frequency.size(), 8);
  const double expected[] = {205.89, 205.89, 210.55, 210.55, 587.92, 587.92, 588.88, 588.88};
  for (int i = 0; i < 8; ++i) {
    EXPECT_NEAR(modes.frequency[i] / expected[i], 1, 0.005) << i;
  }
  // Six rigid modes below half the first elastic frequency, and they store no energy.
  EXPECT_EQ(modes_below(body, 100), 6);
  const Eigen::MatrixXd energy =
      modes.rigid.transpose() * (body.stiffness.selfadjointView<Eigen::Lower>() * modes.rigid);
  EXPECT_LT(std::sqrt(energy.cwiseAbs().maxCoeff()) / 6.283, 1e-2);
}

/// The start vector is fixed: two solves agree to the last bit.
TEST(RingModes, SolvesRepeatExactly) {
  const HexMesh ring = test::ring_mesh(0.345, 0.393, 0.05, 1, 40, 1);
  const BodyMatrices body = assemble_body(ring, {185e9, 0.3, 7800});
  const HeldFactor factor(body.stiffness, rigid_motions(ring.nodes));
  const FreeModes a = free_modes(ring, body, factor, 6);
  const FreeModes b = free_modes(ring, body, factor, 6);
  EXPECT_TRUE(a.frequency == b.frequency);
  EXPECT_TRUE(a.shape == b.shape);
}

}  // namespace
}  // namespace cagetol
