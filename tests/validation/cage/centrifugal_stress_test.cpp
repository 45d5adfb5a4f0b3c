// What turning alone does to the cage: the stress of its centrifugal load by a full static
// solution, and how little of it the kept modes carry (tests/ACCURACY.md has the numbers).
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "src/cage/cage_modes.hpp"
#include "src/cage/cage_recovery.hpp"
#include "src/cage/field_recovery.hpp"
#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

/// Largest von Mises stress under the load of a spin of 1 rad/s [Pa].
struct SpinStress {
  double full = 0, kept_modes = 0;
};

SpinStress spin_stress(const std::vector<PocketDeviation>& deviations) {
  const CageTable& table = test::coarse_table();
  const CageMesh cage = std::get<CageMesh>(make_cage_mesh(table.cage, deviations, table.counts));
  const BodyMatrices body = assemble_body(cage.mesh, table.material);
  const ShiftedFactor factor(body, ring_shift(cage.mesh, body));
  const RigidMotions rigid = mass_orthonormal(rigid_motions(cage.mesh.nodes), body.mass);
  Eigen::VectorXd arm = Eigen::VectorXd::Zero(3 * cage.mesh.nodes.cols());
  for (Eigen::Index n = 0; n < cage.mesh.nodes.cols(); ++n)
    arm.segment<2>(3 * n + 1) = cage.mesh.nodes.col(n).tail<2>();
  const Eigen::VectorXd load = body.mass.selfadjointView<Eigen::Lower>() * arm;
  const Eigen::VectorXd u = free_static_response(body, factor, rigid, load);
  const auto stress = stress_everywhere(cage.mesh, table.material, u);
  SpinStress spin;
  for (Eigen::Index n = 0; n < stress.cols(); ++n)
    spin.full = std::max(spin.full, von_mises(stress.col(n)));

  const CageModel model = std::get<CageModel>(make_cage_model(table, deviations));
  const Eigen::ArrayXd omega = 2 * std::numbers::pi * model.frequency.array();
  const Eigen::VectorXd q = (model.centrifugal.array() / omega.square()).matrix();
  const Eigen::VectorXd no_force = Eigen::VectorXd::Zero(13 * 2 * model.bar_stations);
  spin.kept_modes = station_stress(model, q, no_force).maxCoeff();
  return spin;
}

TEST(CentrifugalStress, IsSmallAndHardlyInTheKeptModes) {
  const double ratio = 31.5 / (31.5 + 46.5);  // cage speed to inner-ring speed, NU 205
  for (const auto& deviations : {std::vector<PocketDeviation>(13), test::scattered_pockets(1)}) {
    const SpinStress spin = spin_stress(deviations);
    for (const double rpm : {6000.0, 15000.0}) {
      const double squared = std::pow(ratio * rpm * std::numbers::pi / 30, 2);
      std::printf("  inner ring %5.0f rpm: %.3f MPa by the full cage, %.4f MPa by the kept modes\n",
                  rpm, 1e-6 * spin.full * squared, 1e-6 * spin.kept_modes * squared);
      EXPECT_LT(1e-6 * spin.full * squared, 4.0 * std::pow(rpm / 15000, 2));
    }
    EXPECT_LT(spin.kept_modes, 0.2 * spin.full);
    // A free ring of the cage's mean radius: rho (Omega r)^2 in hoops, more where bars bend.
    const double hoop = 7850 * std::pow(20.1e-3, 2);
    EXPECT_GT(spin.full, hoop);
  }
}

}  // namespace
}  // namespace cagetol
