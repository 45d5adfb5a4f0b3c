// The guide says of every quantity what it needs, and runs give a number exactly where that is met.
#include "src/quantities/quantity_guide.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/quantities/quantity_table.hpp"
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

class QuantityGuideOf : public testing::TestWithParam<Case> {};

TEST_P(QuantityGuideOf, NamesTheQuantitiesThatARunGives) {
  Scene scene = brief_scene("nu205");
  GetParam().set(scene);
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  for (const Quantity& row : quantity_table())
    EXPECT_EQ(!std::isnan(quantity(outcome, row.key)), quantity_guide(row.key).defined(scene))
        << row.key << " needs " << quantity_guide(row.key).needs;
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, QuantityGuideOf,
    testing::Values(Case{"oiled", [](Scene&) {}},
                    Case{"dry", [](Scene& s) { s.lubrication.model = LubricationModel::none; }},
                    Case{"older_film",
                         [](Scene& s) {
                           s.lubrication.model = LubricationModel::none;
                           s.film.model = FilmModel::series;
                         }},
                    Case{"planar", [](Scene& s) { s.model.rollers = RollerModel::planar; }},
                    Case{"tilting",
                         [](Scene& s) {
                           s.lubrication.model = LubricationModel::none;
                           s.model.ring_tilt = TiltModel::free;
                         }},
                    Case{"part_of_a_turn", [](Scene& s) { s.window.measure_revolutions = 0.4; }},
                    Case{"extrapolated",
                         [](Scene& s) {
                           s.model.rollers = RollerModel::planar;
                           s.discretisation = {1, 1};
                           s.window.measure_revolutions = 5;
                           s.window.extrapolate_revolutions = 100;
                         }},
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

TEST(QuantityGuide, KnowsNoOtherKeys) {
  EXPECT_THROW(quantity_guide("roller_colour"), std::logic_error);
}

}  // namespace
}  // namespace cagetol
