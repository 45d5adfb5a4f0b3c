#include "src/cage/table/bar_modes.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "src/cage/table/cage_model.hpp"
#include "tests/support/flexible_cage.hpp"

namespace cagetol {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

CageModel model_of(const std::vector<PocketDeviation>& deviations,
                   const CageModelOptions& options) {
  return std::get<CageModel>(make_cage_model(test::coarse_table(), deviations, options));
}

/// Rows of the stations of bar 12, between pockets 12 and 0.
MatrixXd bar_rows(const CageModel& model) {
  const long n = model.bar_stations;
  MatrixXd rows(2 * n, model.frequency.size());
  for (long i = 0; i < n; ++i) {
    rows.row(i) = model.contact.row(model.contact_row(12, n + i, 1));
    rows.row(n + i) = model.contact.row(model.contact_row(0, i, 1));
  }
  return rows;
}

/// Compliance of that bar by the modes kept.
MatrixXd kept_compliance(const CageModel& model) {
  const MatrixXd rows = bar_rows(model);
  const Eigen::VectorXd flexibility =
      (2 * std::numbers::pi * model.frequency.array()).square().inverse();
  return rows * flexibility.asDiagonal() * rows.transpose();
}

MatrixXd rest(const CageModel& model) {
  const long both = 2 * model.bar_stations;
  return model.residual_compliance.middleCols(both * 12, both);
}

/// Half on each face, along the stations by their lengths: a force on the bar.
Eigen::VectorXd spread() {
  Eigen::VectorXd force(6);
  force << 0.125, 0.25, 0.125, 0.125, 0.25, 0.125;
  return force;
}

TEST(BarModes, CarryAForceSpreadOverABar) {
  const CageModel without = model_of(std::vector<PocketDeviation>(13), {.bar_modes = false});
  const CageModel with = model_of(std::vector<PocketDeviation>(13), {});
  const double left = spread().dot(rest(without) * spread());
  EXPECT_GT(left, 0.2 * spread().dot(kept_compliance(without) * spread()));
  EXPECT_LT(std::abs(spread().dot(rest(with) * spread())), 1e-6 * left);
  // On one face only, what is left is the line that sinks in.
  Eigen::VectorXd leading = Eigen::VectorXd::Zero(6);
  leading.head<3>() = 2 * spread().head<3>();
  EXPECT_LT(leading.dot(rest(with) * leading), 0.2 * leading.dot(rest(without) * leading));
  EXPECT_EQ(with.elastic_modes(), 10);
  EXPECT_EQ(with.frequency.size(), 23);
  EXPECT_GT(with.frequency[10], with.frequency[9]);
}

TEST(BarModes, ChangeNoStaticResponse) {
  const auto deviations = test::scattered_pockets(7);
  const CageModel without = model_of(deviations, {.bar_modes = false});
  const CageModel with = model_of(deviations, {});
  const MatrixXd compliance = kept_compliance(without) + rest(without);
  EXPECT_LT((kept_compliance(with) + rest(with) - compliance).norm(), 1e-9 * compliance.norm());

  Eigen::VectorXd forces = Eigen::VectorXd::Zero(13 * 6);
  forces[6 * 2 + 3] = 1;
  forces[6 * 3 + 1] = -2;
  forces[6 * 9 + 5] = 3;
  const auto stress = [&](const CageModel& model) {
    Eigen::VectorXd q = Eigen::VectorXd::Zero(model.frequency.size());
    for (long j = 0; j < 13; ++j)
      for (long i = 0; i < 6; ++i)
        q += forces[6 * j + i] * model.contact.row(model.contact_row(j, i, 1)).transpose();
    q.array() /= (2 * std::numbers::pi * model.frequency.array()).square();
    return station_stress(model, q, forces, 100);
  };
  const Eigen::VectorXd expected = stress(without);
  // But that of forces far away is of the undeviated cage, and now there is less of it.
  EXPECT_LT((stress(with) - expected).cwiseAbs().maxCoeff(), 0.03 * expected.maxCoeff());
}

/// With them the compliance under a bar's rollers depends little on how many elastic modes are
/// kept.
TEST(BarModes, SpareElasticModes) {
  const std::vector<PocketDeviation> none(13);
  Eigen::VectorXd leading = Eigen::VectorXd::Zero(6);
  leading.head<3>() = 2 * spread().head<3>();
  const auto kept = [&](long modes, bool bars) {
    const CageModel model = model_of(none, {.modes = modes, .bar_modes = bars, .stress = false});
    return leading.dot(kept_compliance(model) * leading);
  };
  const double all = kept(36, true);
  EXPECT_NEAR(kept(8, true) / all, 1, 0.02);
  EXPECT_LT(kept(36, false) / all, 0.85);
}

}  // namespace
}  // namespace cagetol
