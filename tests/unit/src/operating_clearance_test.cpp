// The operating scene: what changes, by how much, and that everything sees it.
#include "src/operation/operating_clearance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "src/cage/mesh/cage_mass.hpp"
#include "src/model/bearing_model.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/simulate.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The NU 205 with everything that changes its clearance.
Scene fitted_scene() {
  Scene scene;
  scene.fit.inner_interference = 14e-6;
  scene.fit.shaft_bore = 8e-3;
  scene.fit.outer_interference = 6e-6;
  scene.fit.housing_diameter = 90e-3;
  scene.temperature.growth = true;
  scene.temperature.inner_ring = 80;
  scene.temperature.outer_ring = 65;
  scene.temperature.rollers = 75;
  scene.cage.temperature = 70;
  scene.operation.inner_speed = 1500;
  scene.operation.centrifugal_growth = true;
  return scene;
}

void expect_same_dimensions(const Scene& a, const Scene& b) {
  for (const auto& key : scene_keys()) EXPECT_EQ(key_text(key, a), key_text(key, b)) << key.name;
}

TEST(OperatingScene, IsTheSceneItselfByDefault) {
  const Scene scene = shipped_scene("nu205");
  EXPECT_FALSE(changes_in_operation(scene));
  expect_same_dimensions(OperatingScene(scene), scene);
}

TEST(OperatingScene, IsItsOwnOperatingScene) {
  const Scene hot = OperatingScene(fitted_scene());
  EXPECT_FALSE(changes_in_operation(hot));
  expect_same_dimensions(OperatingScene(hot), hot);
  EXPECT_NE(hot.bearing.inner_raceway_diameter, fitted_scene().bearing.inner_raceway_diameter);
}

/// Every length of every part, whatever key gives it.
TEST(OperatingScene, WarmsEveryLengthOfAPart) {
  Scene scene;
  scene.bearing.ring_material = scene.roller.material = scene.cage.material = {"bearing-steel"};
  scene.temperature.growth = true;
  scene.temperature.inner_ring = scene.temperature.outer_ring = scene.cage.temperature = 120;
  scene.bearing.inner_flanges = FlangeSides::both;
  scene.bearing.outer_land_diameter = 43.8e-3;
  scene.cage.guide_clearance = 0.2e-3;  // from 43.4 mm
  int lengths = 0;
  const auto asked = [](const std::string& name) {
    return name.ends_with("_mm") && !name.ends_with("_g_mm") &&
           (name.starts_with("bearing.") || name.starts_with("roller.") ||
            name.starts_with("cage."));
  };
  for (const auto& key : scene_keys())  // a value for what is auto or none
    if (const double value = asked(key.name) ? key_numbers(key, scene)[0] : 1; !(value > 0))
      set_key_numbers(key, {4}, scene);
  const Scene hot = OperatingScene(scene);
  for (const auto& key : scene_keys()) {
    if (!asked(key.name)) continue;
    const double cold = key_numbers(key, scene)[0], warm = key_numbers(key, hot)[0];
    EXPECT_NEAR(warm / cold, 1 + 12e-6 * 100, 1e-9) << key.name;
    ++lengths;
  }
  EXPECT_GT(lengths, 20);
}

/// A bearing of one material that is warm all over keeps its shape: every length grows alike.
TEST(OperatingScene, ScalesABearingThatIsWarmAllOver) {
  Scene scene;
  scene.bearing.ring_material = scene.roller.material = scene.cage.material = {"bearing-steel"};
  scene.temperature.growth = true;
  scene.temperature.inner_ring = scene.temperature.outer_ring = scene.cage.temperature = 120;
  scene.cage.retention_outer = {7.3e-3};
  scene.bearing.inner_land_diameter = 33e-3;
  const double factor = 1 + 12e-6 * 100;
  const Scene hot = OperatingScene(scene);
  const PocketClearances cold = pocket_clearances(scene, 0), warm = pocket_clearances(hot, 0);
  EXPECT_NEAR(warm.tangential / cold.tangential, factor, 1e-9);
  EXPECT_NEAR(warm.axial / cold.axial, factor, 1e-9);
  EXPECT_NEAR(warm.flange / cold.flange, factor, 1e-9);
  for (const int k : {0, 1}) EXPECT_NEAR(warm.ring[k] / cold.ring[k], factor, 1e-9);
  EXPECT_NEAR(warm.radial[1] / cold.radial[1], factor, 1e-6);
  EXPECT_NEAR(hot.bearing.bore_diameter / 25e-3, factor, 1e-12);
  EXPECT_NEAR(hot.bearing.outside_diameter / 52e-3, factor, 1e-12);
  const Growth clearance = operating_clearance(scene).internal(7.5e-3);
  EXPECT_NEAR(clearance.heat, (46.5e-3 - 31.5e-3 - 15e-3) * (factor - 1), 1e-15);
}

/// Moisture makes of a cage what heat of the same strain does, and adds to it.
TEST(OperatingScene, SwellsACageAsHeatOfTheSameStrainDoes) {
  Scene wet;
  wet.cage.material = {"pa66-gf25"};  // 30e-6/K
  wet.cage.guide_clearance = 0.25e-3;
  wet.cage.retention_outer = {7.3e-3};
  Scene warm = wet, both = wet;
  wet.cage.swelling = 0.002;
  both.cage.swelling = 0.001;
  for (Scene* scene : {&warm, &both}) {
    scene->temperature.growth = true;
    scene->temperature.inner_ring = scene->temperature.outer_ring = 20;
  }
  warm.cage.temperature = 20 + 0.002 / 30e-6;
  both.cage.temperature = 20 + 0.001 / 30e-6;
  EXPECT_TRUE(changes_in_operation(wet));
  const Scene swollen = OperatingScene(wet);
  EXPECT_FALSE(changes_in_operation(swollen));
  EXPECT_NEAR(swollen.cage.pocket_width[0], 7.65e-3 * 1.002, 1e-12);
  EXPECT_NEAR(swollen.cage.guide_clearance, 0.25e-3 - 0.002 * 21.7e-3, 1e-12);
  for (const Scene* scene : {&warm, &both}) {
    const Scene hot = OperatingScene(*scene);
    const PocketClearances a = pocket_clearances(hot, 0), b = pocket_clearances(swollen, 0);
    EXPECT_NEAR(a.tangential, b.tangential, 1e-12);
    EXPECT_NEAR(a.axial, b.axial, 1e-12);
    for (const int k : {0, 1}) EXPECT_NEAR(a.ring[k], b.ring[k], 1e-12);
    EXPECT_NEAR(a.radial[1], b.radial[1], 1e-12);
    EXPECT_NEAR(cage_material(hot).density, cage_material(swollen).density, 1e-9);
    for (const auto& key : scene_keys()) {
      if (!key.name.starts_with("cage.") || !key.name.ends_with("_mm")) continue;
      EXPECT_THAT(key_numbers(key, hot)[0],
                  testing::NanSensitiveDoubleNear(key_numbers(key, swollen)[0], 1e-9))
          << key.name;
    }
  }
}

TEST(OperatingScene, KeepsMasses) {
  Scene scene = fitted_scene();
  scene.fit = {};
  scene.operation.centrifugal_growth = false;
  const BearingModel cold = make_bearing_model([&] {
    Scene made = scene;
    made.temperature.growth = false;
    return made;
  }());
  const BearingModel warm = make_bearing_model(scene);
  EXPECT_NE(warm.inner_radius, cold.inner_radius);
  EXPECT_NEAR(warm.groups[0].mass[0] / cold.groups[0].mass[0], 1, 1e-12);
  EXPECT_NEAR(warm.cage_mass / cold.cage_mass, 1, 1e-9);
  EXPECT_NEAR(warm.ring_mass / cold.ring_mass, 1, 1e-4);
}

/// Inner ring and rollers warmer than the outer ring: makers take alpha dT (3 D + d)/4 off the
/// clearance, with alpha = 12.5e-6 (12e-6 here).
TEST(OperatingClearance, ShrinksByTheMakersFormulaWithTheOuterRingColder) {
  Scene scene;
  scene.temperature.growth = true;
  scene.temperature.inner_ring = scene.temperature.rollers = 30;
  scene.temperature.outer_ring = 20;
  const double maker = 12.5e-6 * 10 * (3 * 52e-3 + 25e-3) / 4;
  EXPECT_NEAR(operating_clearance(scene).internal(7.5e-3).heat / -maker, 1, 0.1);
  EXPECT_NEAR(operating_clearance(scene).internal(7.5e-3).heat, -12e-6 * 10 * 46.5e-3, 1e-12);
}

TEST(OperatingClearance, TakesTheTemperatureOfTheNextPartWhereNoneIsGiven) {
  Scene scene;
  scene.temperature.growth = true;
  scene.lubrication.temperature = 70;
  const OperatingClearance oil = operating_clearance(scene);
  EXPECT_NEAR(oil.inner_ring_heat, 12e-6 * 50, 1e-15);
  EXPECT_NEAR(oil.outer_ring_heat, 12e-6 * 50, 1e-15);
  EXPECT_NEAR(oil.cage_growth, 12e-6 * 50, 1e-15);
  scene.temperature.inner_ring = 90;
  scene.temperature.reference = 25;
  scene.fit.inner_interference = 10e-6;
  const OperatingClearance warm = operating_clearance(scene);
  EXPECT_NEAR(warm.roller_heat, 12e-6 * 55, 1e-15);        // 80 degC
  EXPECT_NEAR(warm.inner_fit.interference, 10e-6, 1e-18);  // the shaft is as warm as its ring
  scene.temperature.shaft = 60;
  EXPECT_NEAR(operating_clearance(scene).inner_fit.interference, 10e-6 - 12e-6 * 30 * 25e-3, 1e-15);
  scene.bearing.ring_material.expansion = 20e-6;
  EXPECT_NEAR(operating_clearance(scene).inner_ring_heat, 20e-6 * 65, 1e-15);
}

/// Clearance in operation is that as made and all its changes.
TEST(OperatingClearance, IsTheSumOfItsCauses) {
  const Scene scene = fitted_scene();
  const OperatingPoint at = operating_point(scene);
  EXPECT_NEAR(at.made_clearance.internal, 30e-6, 1e-12);
  double sum = at.made_clearance.internal;
  for (const Growth* change : {&at.inner_change, &at.outer_change, &at.roller_change})
    sum += change->total();
  EXPECT_NEAR(at.clearance.internal, sum, 1e-12);
  EXPECT_NEAR(at.clearance.internal - at.made_clearance.internal,
              operating_clearance(scene).internal(7.5e-3).total(), 1e-12);
  for (const double less : {at.inner_change.fit, at.inner_change.heat, at.inner_change.spin,
                            at.outer_change.fit, at.roller_change.heat, at.roller_change.spin})
    EXPECT_LT(less, -1e-9);
  EXPECT_GT(at.outer_change.heat, 0);
  EXPECT_EQ(at.outer_change.spin, 0);  // it is at rest
  EXPECT_NEAR(at.inner_fit.pressure, operating_clearance(scene).inner_fit.pressure, 0);
}

TEST(OperatingClearance, ReachesModelJamsAndPocketClearances) {
  const Scene scene = fitted_scene(), hot = OperatingScene(scene);
  const BearingModel model = make_bearing_model(scene);
  const OperatingClearance by = operating_clearance(scene);
  EXPECT_NEAR(2 * model.inner_radius, 31.5e-3 - 15e-6 + by.inner_raceway.total(), 1e-15);
  EXPECT_NEAR(2 * model.outer_radius, 46.5e-3 + 15e-6 + by.outer_raceway.total(), 1e-15);
  EXPECT_NEAR(model.nominal_diameter, 7.5e-3 * (1 + 12e-6 * 55) + by.roller_spin, 1e-15);
  EXPECT_NEAR(2 * model.groups[0].half_width[0], 7.65e-3 * (1 + 12e-6 * 50) * (1 + by.cage_spin),
              1e-15);
  EXPECT_NEAR(model.guide_clearance, pocket_clearances(hot, 0).ring[1], 1e-15);
  EXPECT_EQ(find_jam(scene).pocket, -1);
  Scene tight = scene;  // cold: 1 um of clearance, warm: rollers 5 K warmer than the cage
  tight.cage.pocket_width = {7.5003e-3};
  tight.operation.centrifugal_growth = false;
  EXPECT_EQ(find_jam(tight).pocket, 0);
  EXPECT_EQ(simulate(tight).status, Status::jammed);
  tight.temperature.rollers = 65;
  EXPECT_EQ(find_jam(tight).pocket, -1);
}

/// A draw may seize where the nominal scene turns.
TEST(OperatingClearance, SeizesACageThatGrewTooLarge) {
  Scene scene = fitted_scene();
  scene.cage.material = {"pa66-gf25"};
  scene.cage.outer_diameter = 43.77e-3;  // its radius grows by 33 um, that of the shoulders by 12
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::jammed);
  EXPECT_THAT(outcome.reason, HasSubstr("the cage's outside is"));
  scene.temperature.growth = false;
  scene.window.settle_time = 0;
  scene.window.measure_time = 50e-6;
  EXPECT_NE(simulate(scene).status, Status::jammed);
}

/// A guide clearance that is given changes by the growth of both surfaces.
TEST(OperatingClearance, ChangesAGivenGuideClearanceLikeThatOfTheDiameters) {
  for (const Guidance guidance : {Guidance::outer, Guidance::inner}) {
    Scene scene = fitted_scene();
    scene.cage.guidance = guidance;
    const auto change = [&](double given) {
      scene.cage.guide_clearance = given;
      Scene cold = scene;
      cold.fit = {};
      cold.temperature.growth = cold.operation.centrifugal_growth = false;
      return make_bearing_model(scene).guide_clearance - make_bearing_model(cold).guide_clearance;
    };
    const double by_diameters = change(kAuto);
    EXPECT_GT(std::abs(by_diameters), 1e-6);
    EXPECT_NEAR(change(0.3e-3), by_diameters, 1e-12);
  }
}

/// Without pockets to speak of the cage is a thin ring: rho w^2 r^2/E.
TEST(OperatingClearance, WidensTheCageAsAThinRingWithItsBars) {
  Scene scene;
  scene.operation.centrifugal_growth = true;
  scene.operation.inner_speed = 2000;
  const double speed = 2000 * 31.5 / 78, radius = 20.1e-3;
  const double thin = 7850 * speed * speed * radius * radius / 206e9;
  const double loaded = operating_clearance(scene).cage_spin;
  // The bars' share of the mass rides on the side rings.
  const double rings = 14 - 9.25, bars = 9.25 * (1 - 13 * 7.65 / (2 * pi * 20.1));
  EXPECT_NEAR(loaded / thin, (rings + bars) / rings, 1e-3);
  scene.cage.mass = 2 * cage_mass(scene.cage, 13).mass;
  // Pockets are cut at the mean radius here, exactly there.
  EXPECT_NEAR(operating_clearance(scene).cage_spin / loaded, 2, 0.02);
  scene.cage.mass = kAuto;
  scene.cage.pocket_width = {1e-9};
  scene.cage.pocket_length = {1e-9};
  EXPECT_NEAR(operating_clearance(scene).cage_spin / thin, 1, 1e-6);
}

/// A solid disc at the spin of rolling on the outer ring, w_i R_i/(2 R).
TEST(OperatingClearance, WidensRollersAsSolidDiscs) {
  Scene scene;
  scene.operation.centrifugal_growth = true;
  scene.operation.inner_speed = -2000;
  const double spin = 2000 * 15.75 / 7.5, r = 3.75e-3;
  EXPECT_NEAR(operating_clearance(scene).roller_spin,
              2 * 7810 * spin * spin * r * r * r * 0.7 / (4 * 208e9), 1e-15);
}

/// An outer ring alone grows as a ring, pressed into a housing of its steel as one body with it;
/// the cage turns at w_o R_o/(R_i + R_o), rollers at w_o R_o/(2 R).
TEST(OperatingClearance, FollowsAnOuterRingThatTurns) {
  Scene scene;
  scene.operation.centrifugal_growth = true;
  scene.operation.inner_speed = 0;
  scene.operation.outer_speed = 1500;
  const Material steel{208e9, 0.3, 7810};
  const OperatingClearance free = operating_clearance(scene);
  EXPECT_EQ(free.inner_raceway.spin, 0);
  EXPECT_NEAR(free.outer_raceway.spin,
              2 * spinning_growth({23.25e-3, 26e-3, steel}, 1500, 23.25e-3), 1e-15);
  const double spin = 1500 * 23.25 / 7.5, r = 3.75e-3;
  EXPECT_NEAR(free.roller_spin, 2 * 7810 * spin * spin * r * r * r * 0.7 / (4 * 208e9), 1e-15);
  scene.fit.outer_interference = 20e-6;
  scene.fit.housing_diameter = 90e-3;
  scene.fit.housing_material = {"bearing-steel"};
  EXPECT_NEAR(operating_clearance(scene).outer_raceway.spin,
              2 * spinning_growth({23.25e-3, 45e-3, steel}, 1500, 23.25e-3), 1e-15);
  const double strain = free.cage_spin;
  scene.operation.inner_speed = scene.operation.outer_speed;
  scene.operation.outer_speed = 0;
  EXPECT_NEAR(strain / operating_clearance(scene).cage_spin, std::pow(46.5 / 31.5, 2), 1e-12);
}

std::string operating_problem(const std::string& text) {
  try {
    read_scene(reference_scene_table(text, "t.toml"), "t.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(OperatingClearance, RefusesWhatDoesNotTurn) {
  EXPECT_THAT(operating_problem("fit.shaft_bore_mm = 25\n"), HasSubstr("the shaft has no wall"));
  EXPECT_THAT(operating_problem("fit.housing_diameter_mm = 52\n"),
              HasSubstr("the housing has no wall"));
  EXPECT_THAT(operating_problem("temperature.inner_ring_C = 80\n"),
              HasSubstr("set temperature.growth = true"));
  EXPECT_THAT(operating_problem("fit.inner_interference_um = 1000\n"),
              HasSubstr("strain the inner ring by more than 1 %"));
  EXPECT_THAT(operating_problem("fit.outer_interference_um = 1000\n"),
              HasSubstr("strain the outer ring by more than 1 %"));
  EXPECT_THAT(operating_problem("speed.inner_rpm = 1e6\nspeed.centrifugal_growth = true\n"),
              HasSubstr("rotation would strain"));
  const std::string warm =
      "temperature.growth = true\ntemperature.inner_ring_C = 20\n"
      "temperature.outer_ring_C = 20\n";
  EXPECT_EQ(operating_problem(warm), "no error");
  EXPECT_THAT(operating_problem(warm + "temperature.rollers_C = 250\ncage.temperature_C = 20\n"
                                       "cage.pocket_width_mm = 7.51\n"),
              HasSubstr("pocket 0 is not wider than its roller, by 10.7 um"));
  const std::string lips = warm + "cage.temperature_C = 20\ncage.retention_width_outer_mm = 6.71\n";
  EXPECT_EQ(operating_problem(lips), "no error");
  EXPECT_THAT(operating_problem(lips + "temperature.rollers_C = 250\n"),
              HasSubstr("pocket 0 pinches its roller radially"));
  // 30e-6 * 230 K of 21.7 mm are 150 um, the outer ring stays.
  EXPECT_THAT(operating_problem(warm + "cage.temperature_C = 250\ncage.material = \"pa66-gf25\"\n"
                                       "cage.outer_diameter_mm = 43.6\n"),
              HasSubstr("the cage seizes in the outer ring"));
  EXPECT_THAT(operating_problem("cage.swelling_percent = 0.2\n"), HasSubstr("takes up no water"));
  const std::string wet = "cage.material = \"pa66-gf25\"\ncage.swelling_percent = ";
  EXPECT_EQ(operating_problem(wet + "0.2\n"), "no error");
  EXPECT_THAT(operating_problem(wet + "3\ncage.outer_diameter_mm = 43.6\n"),
              HasSubstr("the cage seizes in the outer ring"));
  EXPECT_THAT(operating_problem(warm + "temperature.rollers_C = 250\n"
                                       "bearing.flange_clearance_mm = 0.01\n"),
              HasSubstr("do not fit between their flanges"));
  EXPECT_THAT(operating_problem("bearing.internal_clearance_um = -200\ntemperature.growth = true\n"
                                "temperature.inner_ring_C = 250\ntemperature.outer_ring_C = -60\n"
                                "bearing.ring_expansion_um_m_K = 60\n"),
              HasSubstr("more than a tenth of the roller's diameter"));
}

TEST(OperatingWarnings, NamePreloadAndFitsThatOpen) {
  Scene scene = shipped_scene("nu205");
  scene.fit.inner_interference = 20e-6;
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
  scene.temperature.growth = true;
  scene.temperature.inner_ring = scene.temperature.rollers = scene.temperature.shaft = 70;
  scene.temperature.outer_ring = 40;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("a preload: as made")));
  scene.temperature.outer_ring = 70;
  scene.temperature.shaft = -20;
  EXPECT_THAT(operating_warnings(scene),
              ElementsAre(HasSubstr("inner ring and shaft come loose in operation")));
  scene.fit.inner_interference = kAuto;  // no seat, no news
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
}

}  // namespace
}  // namespace cagetol
