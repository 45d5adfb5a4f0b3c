// Whether the measures of a short window tell a cage that whirls from one that does not.
//
// Pairs of dry scenes differ in one number, by a factor of two. They are labelled without the
// measures, by the path of the cage's centre in long runs from both ends of the clearance
// (nightly). tests/CAGE_STABILITY.md has the figures.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "src/integration/system.hpp"
#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

struct LabelledScene {
  const char* name;
  bool stable;
  double load;       ///< [N]
  double speed;      ///< of the inner ring over that of nu205.toml
  double clearance;  ///< [m]
};

/// Neighbours form a pair.
const std::vector<LabelledScene> kScenes = {
    {"2 kN", true, 2000, 1, 0.2e-3},
    {"4 kN", false, 4000, 1, 0.2e-3},
    {"0.2 mm", true, 1000, 1, 0.2e-3},
    {"0.4 mm", false, 1000, 1, 0.4e-3},
    {"0.1 mm at 8000 rpm", true, 1000, 4.0 / 3, 0.1e-3},
    {"0.2 mm at 8000 rpm", false, 1000, 4.0 / 3, 0.2e-3},
};

/// The limit of the default study on whirl_scatter_ratio.
constexpr double kScatterLimit = 0.3;

/// Start number `n` of `starts`: even ones at 5 %, odd ones at 95 % of the clearance.
Scene started(const LabelledScene& labelled, int n, int starts) {
  Scene scene = dry_scene("nu205");
  scene.operation.radial_load = labelled.load;
  scene.operation.inner_speed *= labelled.speed;
  scene.cage.guide_clearance = labelled.clearance;
  scene.integration.tolerance = 0.015;  // as in the default study
  const double from = (n % 2 == 0 ? 0.05 : 0.95) * labelled.clearance;
  const double angle = 2 * std::numbers::pi * (n + 0.25) / starts;
  scene.start.cage_offset_y = from * std::cos(angle);
  scene.start.cage_offset_z = from * std::sin(angle);
  scene.start.cage_phase = 0.31 * n;
  return scene;
}

/// Extent of the centre's path between two times, the larger of both directions, over twice the
/// clearance.
double extent(const Scene& scene, double from_revolution) {
  double low[2] = {1, 1}, high[2] = {-1, -1};
  const BearingModel bearing = make_bearing_model(scene);
  const double begin = from_revolution * window_times(scene, bearing).revolution;
  const auto see = [&](double t, const double* y, const System& system) {
    if (t < begin) return;
    const double* q = y + system.model.layout.border_position(0);
    double e[2];
    turned_unbalance(system.model, std::cos(q[kCagePhi]), std::sin(q[kCagePhi]), e);
    const double centre[2] = {q[kCageY] - e[0], q[kCageZ] - e[1]};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], centre[k]);
      high[k] = std::max(high[k], centre[k]);
    }
  };
  const Outcome outcome = simulate(scene, {.on_state = see});
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  return std::max(high[0] - low[0], high[1] - low[1]) / (2 * scene.cage.guide_clearance);
}

// Stable: after 100 revolutions the centre keeps to less than half of the clearance for 200 more,
// from wherever it started. Unstable: it goes through more than 0.85 of it.
void expect_label(const LabelledScene& labelled) {
  for (int n = 0; n < 6; ++n) {
    Scene scene = started(labelled, n, 6);
    scene.window.settle_revolutions = 0;
    scene.window.measure_revolutions = 300;
    scene.integration.step_budget = 1000000000;
    const double path = extent(scene, 100);
    SCOPED_TRACE(std::string(labelled.name) + ", start " + std::to_string(n));
    if (labelled.stable)
      EXPECT_LT(path, 0.5);
    else
      EXPECT_GT(path, 0.85);
  }
}

/// Starts of a pair whose short window - that of the default study, after ten revolutions - lies on
/// the side of the limit that its label says.
int told_apart(std::size_t pair, int starts) {
  int right = 0;
  for (const std::size_t k : {2 * pair, 2 * pair + 1})
    for (int n = 0; n < starts; ++n) {
      Scene scene = started(kScenes[k], n, starts);
      scene.window.settle_revolutions = 10;
      const Outcome outcome = simulate(scene);
      EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
      right += (quantity(outcome, "whirl_scatter_ratio") < kScatterLimit) == kScenes[k].stable;
    }
  return right;
}

TEST(CageStability, ScatterOfAShortWindowTellsPairsApart) {
  int right = 0;
  for (std::size_t pair = 0; 2 * pair < kScenes.size(); ++pair) right += told_apart(pair, 4);
  EXPECT_GE(right, 23);  // of 24
}

class NightlyCageStability : public testing::TestWithParam<std::size_t> {};

TEST_P(NightlyCageStability, LabelsHold) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  expect_label(kScenes[2 * GetParam()]);
  expect_label(kScenes[2 * GetParam() + 1]);
}

TEST_P(NightlyCageStability, ScatterTellsApartAtLeast95PercentOfStarts) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  const int right = told_apart(GetParam(), 20);
  RecordProperty("right_of_40", right);
  EXPECT_GE(right, 38);
}

INSTANTIATE_TEST_SUITE_P(Pairs, NightlyCageStability, testing::Values(0u, 1u, 2u));

}  // namespace
}  // namespace cagetol
