#include "src/reading/scene_keys.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <functional>

#include "src/model/bearing_model.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_input.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Scene scene_of(const std::string& text) {
  return read_scene(reference_scene_table(text, "t.toml"), "t.toml");
}

Scene scene_alone(const std::string& text) {
  return read_scene(parse_toml(text, "t.toml"), "t.toml");
}

std::string problem_of(const std::string& text,
                       const std::function<Scene(const std::string&)>& read = scene_of) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SceneKeys, NumbersThatVanishInSIOrOnTheWayBackAreOutOfRange) {
  for (const char* line :
       {"lubrication.race_roughness_um = 5e-324\n", "cage.edge_radius_mm = 1e-320\n",
        "lubrication.pressure_viscosity_1_GPa = 1e-315\n",
        "lubrication.pocket_layer_um = 1.7976931348623157e308\n"})
    EXPECT_THAT(problem_of(line), HasSubstr("outside the range")) << line;
}

std::string scene_path(const std::string& name) {
  return shipped("scenes/" + name + ".toml");
}

void expect_equal(const Scene& a, const Scene& b) {
  for (const auto& key : scene_keys()) EXPECT_EQ(key_text(key, a), key_text(key, b)) << key.name;
}

TEST(SceneKeys, DumpedDefaultsReadBackToTheSameBits) {
  const Scene defaults = example_scene();
  const Scene read = scene_alone(dump_keys(scene_keys(), defaults));
  expect_equal(read, defaults);
  EXPECT_EQ(read.bearing.bore_diameter, defaults.bearing.bore_diameter);
  EXPECT_EQ(read.cage.pocket_width, defaults.cage.pocket_width);
  EXPECT_EQ(read.cage.pocket_length, defaults.cage.pocket_length);
  EXPECT_EQ(read.cage.inner_diameter, defaults.cage.inner_diameter);
  EXPECT_EQ(read.cage.outer_diameter, defaults.cage.outer_diameter);
  EXPECT_EQ(read.bearing.shoulder_diameter, defaults.bearing.shoulder_diameter);
  EXPECT_EQ(read.bearing.internal_clearance, defaults.bearing.internal_clearance);
  EXPECT_EQ(read.operation.inner_speed, defaults.operation.inner_speed);
  EXPECT_EQ(read.contact.race.exponent, defaults.contact.race.exponent);
  EXPECT_EQ(read.contact.race.damping, defaults.contact.race.damping);
  EXPECT_EQ(read.history_interval, defaults.history_interval);
  EXPECT_TRUE(std::isnan(read.cage.mass));
}

/// The keys that a dynamic scene of the reference bearing must give, alone.
std::string required_keys() {
  std::string text;
  for (const auto& key : scene_keys())
    if (key.range.required || !key.range.required_where.empty())
      text += key.name + " = " + key_text(key, example_scene()) + "\n";
  return text;
}

TEST(SceneKeys, WhatIsNotRequiredHasADefault) {
  expect_equal(scene_alone(required_keys()), example_scene());
  EXPECT_EQ(example_scene().name, "scene");
}

TEST(SceneKeys, EveryRequiredKeyIsMissedByItself) {
  int count = 0;
  for (const auto& key : scene_keys()) {
    if (!key.range.required) continue;
    ++count;
    std::string text = required_keys();
    const auto begin = text.find(key.name + " = ");
    text.erase(begin, text.find('\n', begin) + 1 - begin);
    EXPECT_THAT(problem_of(text, scene_alone),
                AllOf(HasSubstr("t.toml: the scene leaves out 1 key that has no default"),
                      HasSubstr("\n    " + key.name +
                                (key.unit == "-" ? ": " : " [" + key.unit + "]: ") + key.meaning),
                      HasSubstr("remedy: give each a value")));
  }
  EXPECT_EQ(count, 18);
}

TEST(SceneMessages, AllMissingKeysAreNamedAtOnce) {
  const auto text = problem_of(
      "[bearing]\nroller_count = 14\ninner_raceway_diameter_mm = 49.5\n"
      "outer_raceway_diameter_mm = 71.5\n[roller]\ndiameter_mm = 11\nlength_mm = 12\n"
      "[load]\nradial_N = 6000\n",
      scene_alone);
  EXPECT_THAT(text, HasSubstr("t.toml: the scene leaves out 13 keys that have no default"));
  for (const char* key :
       {"bearing.bore_diameter_mm", "bearing.outside_diameter_mm", "bearing.width_mm",
        "bearing.shoulder_diameter_mm", "bearing.internal_clearance_um",
        "bearing.flange_clearance_mm", "cage.inner_diameter_mm", "cage.outer_diameter_mm",
        "cage.width_mm", "cage.pocket_width_mm", "cage.pocket_length_mm", "speed.inner_rpm"})
    EXPECT_THAT(text, HasSubstr("\n    " + std::string(key) + " [")) << key;
  EXPECT_THAT(text, HasSubstr("\n    lubrication.model: "));
  EXPECT_THAT(text, Not(HasSubstr("roller_count")));
  EXPECT_THAT(text, HasSubstr("cagetol --dump-default scene"));
}

TEST(SceneMessages, ADistributionWithoutANominalIsNoValue) {
  std::string text = required_keys();
  text.erase(text.find("cage.pocket_width_mm"),
             std::string("cage.pocket_width_mm = 7.65\n").size());
  EXPECT_THAT(
      problem_of(text + "[cage.pocket_width_mm.lot]\nlaw = 'normal'\nsigma = 0.01\n", scene_alone),
      AllOf(HasSubstr("leaves out 1 key"), HasSubstr("its distribution has no nominal")));
}

TEST(SceneKeys, ValuesArriveInSI) {
  const Scene scene = scene_of(
      "[load]\nradial_N = 300\nramp_ms = 2\n[speed]\ninner_rpm = 60\n[start]\ncage_phase_deg = "
      "180\n"
      "[cage]\npolar_inertia_kg_mm2 = 65.58\n[contact.race]\ndamping_N_s_mm = 750");
  EXPECT_DOUBLE_EQ(scene.operation.radial_load, 300);
  EXPECT_DOUBLE_EQ(scene.operation.load_ramp, 2e-3);
  EXPECT_DOUBLE_EQ(scene.operation.inner_speed, 2 * M_PI);
  EXPECT_DOUBLE_EQ(scene.start.cage_phase, M_PI);
  EXPECT_DOUBLE_EQ(scene.cage.polar_inertia, 65.58e-6);
  EXPECT_DOUBLE_EQ(scene.contact.race.damping, 750e3);
}

TEST(SceneKeys, OneNumberPerPocket) {
  const Scene scene =
      scene_of("[bearing]\nroller_count = 3\n[cage]\npocket_width_mm = [7.6, 7.7, 7.8]\n");
  EXPECT_THAT(scene.cage.pocket_width, testing::ElementsAre(7.6e-3, 7.7e-3, 7.8e-3));
}

TEST(SceneKeys, ShippedScenesAreValid) {
  for (const char* name :
       {"nu205", "nu205-thin", "nu205-paper", "nu205-paper-tight", "speed-z16", "speed-z16-skew"})
    EXPECT_EQ(read_scene(read_toml(scene_path(name)), scene_path(name)).name, name);
}

TEST(SceneKeys, SpeedSceneIsTheOneThatSpeedsAreMeasuredOn) {
  const Scene scene = read_scene(read_toml(scene_path("speed-z16")), "speed-z16");
  EXPECT_EQ(scene.bearing.roller_count, 16);
  EXPECT_DOUBLE_EQ(scene.bearing.inner_raceway_diameter, 56.49e-3);
  EXPECT_DOUBLE_EQ(scene.bearing.outer_raceway_diameter, 74.51e-3);
  EXPECT_DOUBLE_EQ(scene.bearing.inner_ring_mass, 0.12);
  EXPECT_DOUBLE_EQ(scene.cage.pocket_width[0] - scene.roller.diameter[0], 9.2e-3 - 9e-3);
  EXPECT_NEAR(scene.cage.pocket_length[0] - scene.roller.length, 0.2e-3, 1e-15);
  const double inner = scene.cage.inner_diameter / 2, outer = scene.cage.outer_diameter / 2;
  EXPECT_NEAR(scene.cage.polar_inertia, 0.06 * (inner * inner + outer * outer) / 2, 1e-14);
  EXPECT_NEAR(scene.cage.transverse_inertia,
              0.06 * (3 * (inner * inner + outer * outer) + 16e-3 * 16e-3) / 12, 1e-14);
  EXPECT_NEAR((scene.bearing.shoulder_diameter - scene.cage.outer_diameter) / 2,
              scene.cage.guide_clearance, 1e-15);
  EXPECT_EQ(scene.contact.bar.law, ForceLaw::impact);
  EXPECT_EQ(scene.contact.race.law, ForceLaw::impact);
  EXPECT_DOUBLE_EQ(scene.window.settle_time, 5e-3);
  EXPECT_DOUBLE_EQ(scene.window.measure_time, 15e-3);
  EXPECT_DOUBLE_EQ(scene.operation.load_ramp, 1e-3);
  EXPECT_EQ(scene.operation.gravity, 0);
}

TEST(SceneKeys, TheModelIsDynamicUnlessToldOtherwise) {
  EXPECT_FALSE(is_quasi_static(scene_of("")));
  EXPECT_TRUE(is_quasi_static(scene_of("model.motion = 'quasi-static'\n")));
  EXPECT_THAT(problem_of("model.motion = 'static'\n"), HasSubstr("choose from dynamic"));
}

TEST(SceneKeys, TheRingTiltsWhereItIsFreeTo) {
  EXPECT_FALSE(has_free_ring_tilt(scene_of("")));
  const std::string free = "model.ring_tilt = 'free'\n";
  EXPECT_TRUE(has_free_ring_tilt(scene_of(free)));
  const Scene scene = scene_of(free +
                               "load.tilting_moment_z_N_m = 3\n[bearing]\n"
                               "tilt_stiffness_N_m_rad = 2e4\ninner_ring_polar_inertia_kg_mm2 = 9\n"
                               "inner_ring_transverse_inertia_kg_mm2 = 6\n");
  const BearingModel model = make_bearing_model(scene);
  EXPECT_EQ(model.duty.fixed.moment_z, 3);
  EXPECT_EQ(model.tilt_stiffness, 2e4);
  EXPECT_DOUBLE_EQ(model.ring_polar, 9e-6);
  EXPECT_DOUBLE_EQ(model.ring_transverse, 6e-6);
}

TEST(SceneKeys, EveryChoiceIsReadAndWrittenAsItIsSpelled) {
  int choices = 0;
  for (const auto& key : scene_keys()) {
    if (key.kind != KeyKind::choice) continue;
    for (const std::string& text : key.range.choices) {
      Scene scene;
      const toml::table root = parse_toml("v = '" + text + "'", "t.toml");
      read_key(key, *root.get("v"), "t.toml", 1, scene);
      EXPECT_EQ(key_text(key, scene), '"' + text + '"') << key.name;
      toml::table written;
      insert_key(key, scene, written);
      EXPECT_EQ(find_node(written, key.name)->value<std::string>(), text) << key.name;
      ++choices;
    }
    Scene scene;
    const toml::table root = parse_toml("v = 'of wood'", "t.toml");
    EXPECT_THROW(read_key(key, *root.get("v"), "t.toml", 1, scene), InputError) << key.name;
  }
  EXPECT_GT(choices, 40);
}

TEST(SceneKeys, AContactMayHaveSomeOfTheForceLaws) {
  const auto laws = [](const char* key) {
    return find_key(scene_keys(), std::string("contact.") + key + ".force_law")->range.choices;
  };
  EXPECT_THAT(laws("race"), testing::ElementsAre("impact", "hertz"));
  EXPECT_THAT(laws("flange"), testing::ElementsAre("impact"));
}

TEST(SceneMessages, ARingTiltThatTheModelDoesNotHave) {
  const auto guided = problem_of("model.ring_tilt = 'free'\ncage.guidance = 'inner'\n");
  EXPECT_THAT(guided, HasSubstr("t.toml:1: model.ring_tilt = \"free\": the lands of a cage do not "
                                "follow the free tilt of the ring that guides it (cage.guidance = "
                                "\"inner\")"));
  EXPECT_THAT(guided, HasSubstr("remedy: set model.ring_tilt = \"prescribed\""));
  const auto moment = problem_of("[load]\ntilting_moment_y_N_m = 2\n");
  EXPECT_THAT(moment, HasSubstr("t.toml:2: load.tilting_moment_y_N_m = 2: a ring whose tilt is "
                                "prescribed hands any moment on to its shaft"));
  EXPECT_THAT(moment, HasSubstr("remedy: set model.ring_tilt = \"free\", or leave the moment out"));
}

TEST(SceneKeys, ADistributionCountsWithItsNominal) {
  const Scene scene = scene_of(
      "[cage]\npocket_width_mm = { nominal = 7.7, lot = { law = 'normal', sigma = 0.01 } }\n"
      "pocket_squareness_mrad = { pocket = { law = 'normal', sigma = 3 } }");
  EXPECT_EQ(scene.cage.pocket_width, std::vector<double>{7.7e-3});
  EXPECT_EQ(scene.cage.pocket_squareness, std::vector<double>{0});
}

TEST(SceneMessages, UnknownKeyNamesTheNearest) {
  const auto text = problem_of("[cage]\nmodel = 'rigid'\npocket_widht_mm = 7.7\n");
  EXPECT_THAT(text, HasSubstr("t.toml:3: cage.pocket_widht_mm = 7.7: no such key"));
  EXPECT_THAT(text, HasSubstr("remedy: did you mean cage.pocket_width_mm?"));
}

TEST(SceneMessages, UnknownSectionEvenWhenEmpty) {
  EXPECT_THAT(problem_of("[cagge]\n"), HasSubstr("t.toml:1: cagge: no such key"));
  EXPECT_EQ(problem_of("[cage]\n"), "no error");
}

TEST(SceneMessages, WrongUnitIsConverted) {
  const auto text = problem_of("[cage]\npocket_width_um = 7650\n");
  EXPECT_THAT(text,
              HasSubstr("t.toml:2: cage.pocket_width_um = 7650: wrong unit: this key is in mm"));
  EXPECT_THAT(text, HasSubstr("write cage.pocket_width_mm = 7.65  (1 um = 0.001 mm)"));
}

TEST(SceneMessages, WrongDimensionAndMissingUnit) {
  EXPECT_THAT(problem_of("load.radial_mm = 7\n"), HasSubstr("this key is a force in N, not in mm"));
  const auto text = problem_of("load.radial = 7\n");
  EXPECT_THAT(text, HasSubstr("t.toml:1: load.radial = 7: the unit is missing"));
  EXPECT_THAT(text, HasSubstr("write load.radial_N, in N"));
}

TEST(SceneMessages, WrongTypes) {
  EXPECT_THAT(problem_of("load.radial_N = 'much'\n"),
              HasSubstr("this is a text, expected a number in N"));
  EXPECT_THAT(problem_of("load.radial_N = true\n"), HasSubstr("expected a number in N"));
  EXPECT_THAT(problem_of("bearing.roller_count = 13.5\n"),
              HasSubstr("expected a whole number, from 3 to 64"));
  EXPECT_THAT(problem_of("cage.model = 5\n"), HasSubstr("expected a text in quotes"));
  EXPECT_THAT(problem_of("lubrication.squeeze = 'yes'\n"), HasSubstr("expected true or false"));
  EXPECT_THAT(problem_of("load.radial_N = 2024-01-01\n"), HasSubstr("a date or time"));
  EXPECT_THAT(problem_of("load = 5\n"),
              HasSubstr("t.toml:1: load = 5: this is a section, not a key"));
  EXPECT_THAT(problem_of("cage.mass_kg = 'heavy'\n"), HasSubstr("or \"auto\""));
}

TEST(SceneMessages, RangesAreNamed) {
  EXPECT_THAT(problem_of("cage.pocket_length_mm = -9.25\n"),
              HasSubstr("t.toml:1: cage.pocket_length_mm = -9.25: outside the range of this key"));
  EXPECT_THAT(problem_of("cage.pocket_length_mm = -9.25\n"), HasSubstr("give a value above 0 mm"));
  EXPECT_THAT(problem_of("bearing.roller_count = 9000000000\n"),
              HasSubstr("give a value from 3 to 64"));
  EXPECT_THAT(problem_of("cage.model = 'stiff'\n"), HasSubstr("choose from rigid"));
}

TEST(SceneMessages, NotANumberAndInfinity) {
  EXPECT_THAT(problem_of("load.radial_N = nan\n"),
              HasSubstr("t.toml:1: load.radial_N = nan: not a finite number"));
  EXPECT_THAT(problem_of("cage.pocket_pitch_mrad = -inf\n"), HasSubstr("not a finite number"));
  EXPECT_THAT(problem_of("cage.pocket_width_mm = [7.6, nan, 7.6]\nbearing.roller_count = 3\n"),
              HasSubstr("not a finite number"));
}

TEST(SceneMessages, ArraysOfTheWrongLength) {
  const auto text = problem_of("cage.pocket_width_mm = [7.6, 7.7]\n");
  EXPECT_THAT(text, HasSubstr("an array of 2 values, but there are 13 rollers"));
  EXPECT_THAT(text, HasSubstr("give one number for all, or an array of 13"));
}

TEST(SceneMessages, NominalPocketSmallerThanItsRoller) {
  const auto text = problem_of("[roller]\ndiameter_mm = 7.5\n[cage]\npocket_width_mm = 7.4\n");
  EXPECT_THAT(text, HasSubstr("t.toml:4: cage.pocket_width_mm = 7.4"));
  EXPECT_THAT(text, HasSubstr("roller.diameter_mm = 7.5"));
  EXPECT_THAT(text, HasSubstr("remedy: give a pocket width above the roller diameter"));
  EXPECT_THAT(problem_of("cage.pocket_length_mm = 9\n"), HasSubstr("not longer than its roller"));
  EXPECT_EQ(problem_of("cage.pocket_width_mm = 7.4\ncage.allow_interference = true\n"), "no error");
}

TEST(SceneMessages, BodiesThatDoNotFitEachOther) {
  EXPECT_THAT(problem_of("cage.outer_diameter_mm = 44\n"),
              HasSubstr("does not fit inside the outer ring's shoulders"));
  EXPECT_THAT(problem_of("cage.inner_diameter_mm = 30\n"),
              HasSubstr("does not fit over the inner ring"));
  EXPECT_THAT(problem_of("cage.inner_diameter_mm = 43.5\n"), HasSubstr("no wall"));
  EXPECT_THAT(problem_of("cage.pocket_width_mm = 8.95\n"), HasSubstr("leave no bar between them"));
  EXPECT_THAT(problem_of("cage.pocket_length_mm = 14\n"), HasSubstr("no side rings"));
  EXPECT_THAT(problem_of("bearing.outer_raceway_diameter_mm = 48\n"),
              HasSubstr("do not fill the gap"));
  EXPECT_THAT(problem_of("bearing.shoulder_diameter_mm = 47\n"),
              HasSubstr("the shoulders must stand between"));
  EXPECT_THAT(problem_of("bearing.bore_diameter_mm = 32\n"),
              HasSubstr("not smaller than the inner raceway"));
  EXPECT_THAT(problem_of("bearing.outside_diameter_mm = 46\n"), HasSubstr("outside diameter"));
  EXPECT_THAT(problem_of("roller.length_mm = 16\n"),
              HasSubstr("not shorter than the bearing is wide"));
  EXPECT_THAT(problem_of("cage.land_offset_mm = 8\n"), HasSubstr("lie outside the cage"));
  EXPECT_THAT(problem_of("friction.static_speed_m_s = 2\n"),
              HasSubstr("friction.dynamic_speed_m_s = 1"));
  EXPECT_THAT(problem_of("speed.inner_rpm = 0\n"), HasSubstr("window.measure_time_s"));
  EXPECT_THAT(
      problem_of("[model]\nmotion = 'quasi-static'\n[cage]\nmodel = 'flexible'\n"),
      AllOf(HasSubstr("t.toml:4: cage.model"), HasSubstr("remedy: set cage.model = \"rigid\"")));
}

TEST(SceneKeys, PeaksAreTakenOverAPartOfTheWindow) {
  EXPECT_EQ(scene_of("[window]\npeak_revolutions = 3\n").window.peak_revolutions, 3);
  EXPECT_THAT(problem_of("[window]\npeak_revolutions = 7\n"),
              AllOf(HasSubstr("the window is shorter (window.measure_revolutions = 6)"),
                    HasSubstr("remedy: give at most window.measure_revolutions")));
  EXPECT_THAT(problem_of("[window]\nmeasure_time_s = 1\npeak_revolutions = 1\n"),
              HasSubstr("the window is given in seconds (window.measure_time_s = 1)"));
}

TEST(SceneKeys, EveryKeyHasAMeaningAndAUnitThatItsNameShows) {
  for (const auto& key : scene_keys()) {
    EXPECT_FALSE(key.meaning.empty()) << key.name;
    const bool pure =
        key.kind != KeyKind::number && key.kind != KeyKind::numbers && key.kind != KeyKind::list;
    if (pure) {
      EXPECT_EQ(key.unit, "-") << key.name;
    }
  }
}

}  // namespace
}  // namespace cagetol
