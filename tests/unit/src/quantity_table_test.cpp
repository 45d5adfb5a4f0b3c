// A row says what its quantity needs, and runs give a number exactly where that is met; its kind is
// the one that key and definition say.
#include "src/quantities/quantity_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

/// Loosely integrated: whether there is a number is asked, not which.
Scene brief_scene(const std::string& name) {
  Scene scene = shipped_scene(name);
  scene.integration.method = IntegrationMethod::rodas3;
  scene.integration.tolerance = 0.015;
  scene.start.state = StartState::equilibrium;
  scene.discretisation = {.race_slices = 3, .bar_stations = 2};
  scene.window = {};
  scene.window.settle_revolutions = 0.1;
  scene.window.measure_revolutions = 1.2;
  scene.window.longest_settle_revolutions = 0;
  scene.watch = {1e9, 1e9, 1e9, 1e9};
  return scene;
}

struct Case {
  std::string name;
  void (*set)(Scene&);
};

class QuantitiesOf : public testing::TestWithParam<Case> {};

TEST_P(QuantitiesOf, AreThoseWhoseNeedsItMeets) {
  Scene scene = brief_scene("nu205");
  GetParam().set(scene);
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  for (const Quantity& row : quantity_table())
    EXPECT_EQ(!std::isnan(quantity(outcome, row.key)), row.need.met(scene))
        << row.key << " needs " << row.need.text;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, QuantitiesOf,
    testing::Values(Case{"oiled", [](Scene&) {}},
                    Case{"dry", [](Scene& s) { s.lubrication.model = LubricationModel::none; }},
                    Case{"tilting",
                         [](Scene& s) {
                           s.lubrication.model = LubricationModel::none;
                           s.model.ring_tilt = TiltModel::free;
                         }},
                    Case{"part_of_a_turn", [](Scene& s) { s.window.measure_revolutions = 0.4; }},
                    Case{"flexible",
                         [](Scene& s) {
                           s.cage.model = CageKind::flexible;
                           s.cage.mesh_density = 1;
                           s.cage.corner_radius = 0;
                           s.window.measure_revolutions = 1;
                         }},
                    Case{"equilibria",
                         [](Scene& s) { s.model.motion = MotionModel::quasi_static; }}),
    [](const auto& one) { return one.param.name; });

TEST(QuantityTable, ExtremesAreThoseThatSayPeakOrQuantileOrThinnest) {
  for (const Quantity& row : quantity_table()) {
    const std::string definition = row.definition;
    bool says = false;
    for (const char* word : {"largest value", "largest sliding", "largest acceleration", "quantile",
                             "largest von Mises", "thinnest", "smallest", "peak"})
      says |= definition.find(word) != std::string::npos;
    EXPECT_EQ(is_extreme(row.kind), says) << row.key;
  }
}

// What users read from a key holds for its row.
TEST(QuantityTable, KindsAreThoseThatKeysSay) {
  for (const Quantity& row : quantity_table()) {
    const std::string key = row.key;
    const auto says = [&](const char* part) { return key.find(part) != std::string::npos; };
    EXPECT_EQ(row.kind == Kind::minimum, says("_min_")) << key;
    EXPECT_EQ(row.kind == Kind::place, key.ends_with("_pocket") || key.ends_with("_station"));
    EXPECT_EQ(row.kind == Kind::power,
              says("power_") || says("torque") || says("heat_") || says("_temperature"))
        << key;
    if (says("_p95") || says("_p99") || says("_utilisation") || key.ends_with("_peak_N")) {
      EXPECT_EQ(row.kind, Kind::peak) << key;
    }
    if (row.kind == Kind::place || *row.peak) {
      EXPECT_EQ(quantity_named(row.peak).kind, Kind::peak) << key;
    }
  }
}

TEST(QuantityTable, NamesMayHaveLabels) {
  EXPECT_STREQ(quantity_named("film_min_um@idle.braking").key, "film_min_um");
  EXPECT_THROW(quantity_named("roller_colour"), std::out_of_range);
}

}  // namespace
}  // namespace cagetol
