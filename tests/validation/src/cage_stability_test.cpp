// Whether the measures of a short window tell a cage that whirls from one that does not.
//
// Pairs of dry scenes differ in one number, by a factor of two. They are labelled without the
// measures, by the path of the cage's centre in long runs from both ends of the clearance
// (nightly). In oil, scenes are labelled by growth and decay of small and large starts, seen in the
// frames that rest and that turn with the load and with the cage. tests/CAGE_STABILITY.md has the
// figures.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "src/integration/system.hpp"
#include "src/quantities/centre_path.hpp"
#include "src/quantities/window_times.hpp"
#include "src/scene/whirl_window.hpp"
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

/// Of dry scenes, between stable and unstable ones.
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

/// The NU 205 in oil at `faster` times its speed.
Scene oiled(double faster) {
  Scene scene = shipped_scene("nu205");
  scene.integration.tolerance = 0.015;
  scene.operation.inner_speed *= faster;
  return scene;
}
Scene light(double internal_clearance) {
  Scene scene = oiled(2);
  scene.operation.radial_load = 300;
  scene.bearing.internal_clearance = internal_clearance;
  return scene;
}
Scene turning_load(double faster) {
  Scene scene = oiled(faster);
  std::swap(scene.operation.radial_load, scene.operation.rotating_load);  // 1 kN
  return scene;
}
/// On a vertical shaft, preloaded all round. Whirl is over half of `widest`, the larger pocket
/// clearance of the pair.
Scene uniform(Scene scene, double internal_clearance, double pocket_clearance, double widest) {
  scene.cage.model = CageKind::rigid;
  scene.operation.shaft_inclination = std::numbers::pi / 2;
  scene.operation.radial_load = 0;
  scene.bearing.internal_clearance = internal_clearance;
  scene.window.whirl_clearance = widest / 2;
  scene.cage.pocket_width = {scene.roller.diameter.front() + pocket_clearance};
  return scene;
}
Scene vertical(double pocket_clearance) {
  return uniform(oiled(4), -10e-6, pocket_clearance, 0.15e-3);
}
Scene inner_guided(double pocket_clearance) {
  Scene scene = shipped_scene("aero118-inner");
  scene.integration.tolerance = 0.002;
  return uniform(std::move(scene), -110e-6, pocket_clearance, 0.2e-3);
}

/// A scene in oil and what its cage does from small and from large starts; neighbours differ in one
/// number, by a factor of two where a factor tells.
struct OiledScene {
  const char* name;
  std::string from_small, from_large;
  Scene scene;
};

const std::vector<OiledScene>& oiled_scenes() {
  static const std::vector<OiledScene> scenes = {
      {"300 N, no clearance", "stable", "stable", light(0)},
      {"300 N, 2 um preload", "circling", "circling", light(-2e-6)},
      {"turning load, 12000 rpm", "stable", "stable", turning_load(2)},
      {"turning load, 24000 rpm", "whirling", "whirling", turning_load(4)},
      {"vertical, pockets of 0.05 mm", "stable", "circling", vertical(0.05e-3)},
      {"vertical, pockets of 0.15 mm", "whirling", "circling", vertical(0.15e-3)},
      {"inner-guided, pockets of 0.08 mm", "stable", "circling", inner_guided(0.08e-3)},
      {"inner-guided, pockets of 0.2 mm", "whirling", "circling", inner_guided(0.2e-3)},
  };
  return scenes;
}

/// Start number `n` of `starts`, `from` of the guide clearance off the middle.
Scene started(const OiledScene& oiled, int n, int starts, double from) {
  Scene scene = oiled.scene;
  const double clearance = make_bearing_model(scene).guide_clearance;
  const double angle = 2 * std::numbers::pi * (n + 0.25) / starts;
  scene.start.cage_offset_y = from * clearance * std::cos(angle);
  scene.start.cage_offset_z = from * clearance * std::sin(angle);
  scene.start.cage_phase = 0.31 * n;
  scene.window.settle_revolutions = 40;
  scene.window.measure_revolutions = load_turns(scene) ? kWhirlTurnsBesideLoad : kWhirlTurns;
  return scene;
}

/// Half the extent, over the clearance that confines the cage, of the centre's path over the last
/// 20 of 60 revolutions, in frames that rest and turn with the load; half that of its distance from
/// its mean place; and how fast it goes round that, over the cage's speed.
struct Extents {
  double at_rest, with_load, of_radius, winding;
};
Extents extents_of(Scene scene) {
  const BearingModel bearing = make_bearing_model(scene);
  const double clearance = given_or(scene.window.whirl_clearance, whirl_clearance(bearing));
  scene.window.settle_revolutions = 0;
  scene.window.measure_revolutions = 60;
  const double begin = 40 * window_times(scene, bearing).revolution,
               load_speed = scene.operation.inner_speed;
  using Point = std::complex<double>;
  std::vector<Point> path;
  std::vector<double> load, cage;
  const auto see = [&](double t, const double* y, const System& system) {
    if (t < begin) return;
    const double* q = y + system.model.layout.border_position(0);
    double e[2];
    turned_unbalance(system.model, std::cos(q[kCagePhi]), std::sin(q[kCagePhi]), e);
    path.emplace_back(q[kCageY] - e[0], q[kCageZ] - e[1]);
    load.push_back(load_speed * t);
    cage.push_back(q[kCagePhi]);
  };
  const Outcome outcome = simulate(scene, {.on_state = see});
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  const auto half = [&](const std::function<double(std::size_t)>& value) {
    double low = 1, high = -1;
    for (std::size_t k = 0; k < path.size(); ++k) {
      low = std::min(low, value(k));
      high = std::max(high, value(k));
    }
    return (high - low) / 2 / clearance;
  };
  const auto extent = [&](double turning) {
    const auto at = [&](std::size_t k) { return path[k] * std::polar(1.0, -turning * load[k]); };
    return std::max(half([&](std::size_t k) { return at(k).real(); }),
                    half([&](std::size_t k) { return at(k).imag(); }));
  };
  // Steps are nearly equal.
  const Point middle =
      std::accumulate(path.begin(), path.end(), Point{}) / static_cast<double>(path.size());
  double wound = 0;
  for (std::size_t k = 1; k < path.size(); ++k)
    wound += std::arg((path[k] - middle) / (path[k - 1] - middle));
  return {extent(0), extent(1), half([&](std::size_t k) { return std::abs(path[k] - middle); }),
          wound / (cage.back() - cage.front())};
}

/// What the path says: at rest or following the load, circling about as fast as the cage turns, or
/// neither.
std::string label_of(const Extents& path) {
  if (std::min(path.at_rest, path.with_load) < 0.5) return "stable";
  const bool circles = path.of_radius < 0.5 && path.winding > 0.8 && path.winding < 1.2;
  return circles ? "circling" : "whirling";
}

/// Starts, small and large ones in turn, that the measure calls by the label.
int called_right(const OiledScene& oiled, int starts) {
  int right = 0;
  for (int n = 0; n < starts; ++n) {
    const bool small = n % 2 == 0;
    const Outcome outcome = simulate(started(oiled, n, starts, small ? 0.02 : 0.8));
    EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
    const std::string called =
        whirl_class(quantity(outcome, "whirl_ratio"), quantity(outcome, "whirl_load_line_ratio"),
                    quantity(outcome, "whirl_circling_ratio"));
    if (n < 2)
      std::printf("%s, %s start: %s, whirl %.2f, circling %.2f, speed %.1f\n", oiled.name,
                  small ? "small" : "large", called.c_str(), quantity(outcome, "whirl_ratio"),
                  quantity(outcome, "whirl_circling_ratio"),
                  quantity(outcome, "whirl_strongest_speed_ratio"));
    right += called == (small ? oiled.from_small : oiled.from_large);
  }
  return right;
}

TEST(WhirlInOil, PocketClearanceDecidesUnderUniformLoad) {
  EXPECT_EQ(called_right(oiled_scenes()[4], 1), 1);
  EXPECT_EQ(called_right(oiled_scenes()[5], 1), 1);
}

TEST(WhirlInOil, TheDefaultSceneIsStable) {
  const OiledScene usual{"default", "stable", "stable", oiled(1)};
  EXPECT_EQ(called_right(usual, 2), 2);
}

class NightlyWhirlInOil : public testing::TestWithParam<std::size_t> {};

TEST_P(NightlyWhirlInOil, SmallAndLargeStartsEndAsTheLabelSays) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  const OiledScene& oiled = oiled_scenes()[GetParam()];
  for (const double from : {0.02, 0.8}) {
    const Extents path = extents_of(started(oiled, 0, 20, from));
    EXPECT_EQ(label_of(path), from < 0.5 ? oiled.from_small : oiled.from_large)
        << oiled.name << ", start at " << from << ": extent " << path.at_rest << " at rest, "
        << path.with_load << " with the load, " << path.of_radius << " of the radius, winding "
        << path.winding;
  }
}

TEST_P(NightlyWhirlInOil, MeasureCallsAtLeast18Of20StartsByTheLabel) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  const int right = called_right(oiled_scenes()[GetParam()], 20);
  RecordProperty("right_of_20", right);
  EXPECT_GE(right, 19) << oiled_scenes()[GetParam()].name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, NightlyWhirlInOil, testing::Range(std::size_t{0}, std::size_t{8}));

}  // namespace
}  // namespace cagetol
