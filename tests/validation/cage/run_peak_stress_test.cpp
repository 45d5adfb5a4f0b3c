// The stress that a run reports against the whole stress field, recovered on the full mesh with
// static correction, at instants of that run.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "src/cage/cage_recovery.hpp"
#include "src/cage/scene_cage.hpp"
#include "src/integration/system.hpp"
#include "src/simulate.hpp"

namespace cagetol {
namespace {

TEST(RunPeakStress, IsThatOfTheWholeField) {
  Scene scene;
  scene.cage.model = "flexible";
  scene.window.settle_time = 1e-3;
  scene.window.measure_time = 30e-3;
  scene.watch.static_consistency_max = 1;
  const auto table = make_scene_cage_table(scene);
  std::vector<Eigen::VectorXd> q, force;
  std::vector<double> spin;
  SimulateOptions options{.cage_table = table};
  double next = scene.window.settle_time;
  options.on_state = [&](double t, const double* y, const System& system) {
    if (t < next || system.seen.bar_force.isZero()) return;
    next = t + 1e-3;  // an instant with contact every millisecond
    const StateLayout& l = system.model.layout;
    q.emplace_back(Eigen::Map<const Eigen::VectorXd>(y + l.border_position(kModes), l.modes));
    force.push_back(system.seen.bar_force);
    spin.push_back(system.seen.centrifugal_spin);
  };
  ASSERT_EQ(simulate(scene, options).status, Status::ok);
  ASSERT_GE(q.size(), 15U);
  CageStates states{Eigen::MatrixXd(q[0].size(), q.size()),
                    Eigen::MatrixXd(force[0].size(), q.size()),
                    Eigen::Map<const Eigen::VectorXd>(spin.data(), std::ssize(spin))};
  for (std::size_t i = 0; i < q.size(); ++i) {
    states.q.col(static_cast<Eigen::Index>(i)) = q[i];
    states.bar_force.col(static_cast<Eigen::Index>(i)) = force[i];
  }
  const auto compared =
      compare_peak_stress(*table, pocket_deviations(scene.cage, table->cage), states);
  std::vector<double> errors;
  for (const PeakStress& peak : std::get<std::vector<PeakStress>>(compared)) {
    const double error = peak.stations / peak.full - 1;
    errors.push_back(std::abs(error));
    std::printf("  %.4f MPa by stations, %.4f MPa by the whole field: %+.2f %%\n",
                1e-6 * peak.stations, 1e-6 * peak.full, 100 * error);
  }
  // Now and then a peak lies between stations, or a part of it comes from two pockets away.
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.002);
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.01);
  EXPECT_LT(errors.back(), 0.04);
}

}  // namespace
}  // namespace cagetol
