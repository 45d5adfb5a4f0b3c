// Static stress of single bar forces beyond the kept modes, by the per-sample model, against the
// whole field of a full solve, on a cage with scattered pockets and the default mesh.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "src/cage/cage_recovery.hpp"
#include "src/cage/field_recovery.hpp"
#include "src/cage/scene_cage.hpp"

namespace cagetol {
namespace {

TEST(BarForceStress, IsThatOfTheWholeCageAtEveryStation) {
  Scene scene;
  scene.cage.model = "flexible";
  const auto table = make_scene_cage_table(scene);
  std::vector<PocketDeviation> deviations(13);
  for (std::size_t j = 0; j < 13; ++j)
    deviations[j] = {.width = 75e-6 * std::sin(1 + 5 * static_cast<double>(j)),
                     .length = 75e-6 * std::sin(2 + 3 * static_cast<double>(j))};
  const CageModel model = std::get<CageModel>(make_cage_model(*table, deviations));
  constexpr Eigen::Index forces = 24, first = 12;  // every station of pockets 2 to 5
  CageStates states{Eigen::MatrixXd::Zero(model.frequency.size(), forces),
                    Eigen::MatrixXd::Zero(13 * 6, forces), Eigen::VectorXd::Zero(forces)};
  for (Eigen::Index i = 0; i < forces; ++i) states.bar_force(first + i, i) = 1;
  const auto recovery = std::get<CageRecovery>(recover_cage(*table, deviations, states));
  const std::vector<int> points = stress_stations(table->cage, table->stations, recovery.mesh.grid);
  double worst = 0;
  for (Eigen::Index i = 0; i < forces; ++i) {
    const auto full =
        stress_everywhere(recovery.mesh.mesh, table->material, recovery.displacement.col(i));
    const Eigen::VectorXd stations =
        station_stress(model, states.q.col(i), states.bar_force.col(i));
    double largest = 0, off = 0;
    Eigen::Index place = 0;
    for (const auto& nodes : recovery.mesh.sector_node)
      for (const int point : points) {
        const double exact = von_mises(full.col(nodes[static_cast<std::size_t>(point)]));
        largest = std::max(largest, exact);
        off = std::max(off, std::abs(stations[place++] - exact));
      }
    worst = std::max(worst, off / largest);
  }
  std::printf("static rest of a bar force: %.2f %% of its largest off at worst\n", 100 * worst);
  EXPECT_LT(worst, 0.035);
}

}  // namespace
}  // namespace cagetol
