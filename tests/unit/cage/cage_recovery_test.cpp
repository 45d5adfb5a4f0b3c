#include "src/cage/cage_recovery.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

struct States {
  MatrixXd q;
  MatrixXd bar_forces;
};

/// Rollers press on some bars by up to 20 N, along the bar as they lie, and every mode rings with a
/// static deflection's worth of amplitude or less.
States random_states(const CageModel& model, Index count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal;
  const Index n = model.bar_stations;
  States states{MatrixXd::Zero(model.frequency.size(), count), MatrixXd::Zero(26 * n, count)};
  const Eigen::ArrayXd omega = 2 * std::numbers::pi * model.frequency.array();
  for (Index i = 0; i < count; ++i) {
    Eigen::VectorXd modal = Eigen::VectorXd::Zero(model.frequency.size());
    for (Index face = 0; face < 26; ++face) {
      if (uniform(random) > 0.3) continue;
      const double force = (face % 2 == 0 ? -20 : 20) * uniform(random);
      const double skew = 0.5 * (2 * uniform(random) - 1);
      for (Index s = 0; s < n; ++s) {
        const double along =
            n == 1 ? 0 : 2.0 * static_cast<double>(s) / static_cast<double>(n - 1) - 1;
        const double share = force * (1 + skew * along) / static_cast<double>(n);
        states.bar_forces(n * face + s, i) = share;
        modal += share * model.contact.row(model.contact_row(face / 2, face % 2 * n + s, 1));
      }
    }
    const Eigen::ArrayXd still = modal.array() / omega.square();
    for (Index k = 0; k < still.size(); ++k) states.q(k, i) = still[k] * (1 + normal(random));
  }
  return states;
}

/// Statics and vibration together: the stations' peak against every node of the full recovery.
TEST(CageRecovery, StationPeakWithinThreePercentOfTheWholeCage) {
  double worst = 0;
  double sum = 0;
  long all = 0;
  for (unsigned seed : {1U, 2U, 3U, 4U}) {
    const auto deviations = test::scattered_pockets(seed);
    const CageModel model =
        std::get<CageModel>(make_cage_model(test::coarse_table(), deviations, {.stress = false}));
    const States states = random_states(model, 50, seed);
    const auto compared =
        compare_peak_stress(test::coarse_table(), deviations, states.q, states.bar_forces);
    for (const PeakStress& peak : std::get<std::vector<PeakStress>>(compared)) {
      const double error = peak.stations / peak.full - 1;
      EXPECT_LT(std::abs(error), 0.03) << seed << ": " << peak.stations << " " << peak.full;
      worst = std::max(worst, std::abs(error));
      sum += error * error;
      ++all;
    }
  }
  std::printf("peak stress, %ld states: rms error %.2f %%, largest %.2f %%\n", all,
              100 * std::sqrt(sum / static_cast<double>(all)), 100 * worst);
}

/// A mode's displacement at a contact point is the model's, whatever sign or mixture the full solve
/// gives its modes in.
TEST(CageRecovery, ModesAreThoseOfTheModel) {
  const auto deviations = test::scattered_pockets(5);
  const CageModel model = std::get<CageModel>(make_cage_model(test::coarse_table(), deviations));
  const Index kept = model.frequency.size();
  const auto recovered =
      recover_cage(test::coarse_table(), deviations, MatrixXd::Identity(kept, kept),
                   MatrixXd::Zero(26 * model.bar_stations, kept));
  const auto& [mesh, shapes] = std::get<CageRecovery>(recovered);
  const long pocket = 4;
  const auto& node = mesh.sector_node[pocket];
  const MatrixXd turn = sector_rotation(mesh.cage, pocket).transpose();
  MatrixXd fields(3 * static_cast<Index>(node.size()), kept);
  for (std::size_t p = 0; p < node.size(); ++p) {
    fields.middleRows<3>(3 * static_cast<Index>(p)) = turn * shapes.middleRows<3>(3 * node[p]);
  }
  const MatrixXd rows =
      contact_rows(mesh.cage, test::coarse_table().stations, mesh.grid, deviations[pocket], fields);
  const MatrixXd expected = model.contact.middleRows(3 * model.points * pocket, 3 * model.points);
  for (Index k = 0; k < kept; ++k) {
    EXPECT_LT((rows.col(k) - expected.col(k)).norm(), 0.03 * expected.col(k).norm()) << k;
  }
}

}  // namespace
}  // namespace cagetol
