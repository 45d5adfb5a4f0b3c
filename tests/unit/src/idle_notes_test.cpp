// Every key of a scene either changes what is computed or is named as idle, in scenes that differ
// in what they model.
#include "src/reading/idle_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <random>
#include <set>

#include "src/integration/system.hpp"
#include "src/quantities/window_times.hpp"
#include "src/scene/materials.hpp"
#include "src/scene/pocket_outline.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// What a run takes from a scene: its start, the rates at states in which everything touches, its
/// window, and its results.
std::vector<double> fingerprint(const Scene& scene) {
  std::vector<double> print;
  Scene brief = scene;
  brief.window = {};
  brief.window.settle_time = 0;
  brief.window.measure_time = 60e-6;
  brief.integration.max_step = std::fmin(brief.integration.max_step, 20e-6);  // also of "auto"
  const Outcome outcome = simulate(brief);
  print = outcome.quantities;
  print.push_back(outcome.run.steps);
  print.push_back(static_cast<double>(outcome.pocket));
  if (is_quasi_static(scene)) return print;
  const BearingModel model = make_bearing_model(scene);
  const WindowTimes times = window_times(scene, model);
  for (const double time : {times.settle, times.measure, times.peak_turns}) print.push_back(time);
  if (is_lubricated(scene)) print.push_back(times.longest_settle);
  print.push_back(scene.integration.max_step);
  print.push_back(scene.integration.tolerance);  // in so short a run it may change no step
  System system(model);
  const auto start = start_state(model, scene.start);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  // Places off the start by micrometres, speeds by centimetres a second off the start's or off
  // rest.
  struct Apart {
    double place, speed, share;
  };
  for (const Apart& apart :
       {Apart{0, 0, 1}, {100, 30, 1}, {100, 30, 0}, {60, 12, 0}, {100, 3, 0}, {0, 0, 0.5}}) {
    PackVector y(start.begin(), start.end());
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double draw = normal(random);
      const bool speed = i >= y.size() / 2;
      if (speed) y[i] *= apart.share;
      if (system.scale[i] < 1e20)
        y[i] += (speed ? apart.speed : apart.place) * draw * system.scale[i];
    }
    if (apart.share == 0.5) {  // onto the edges of the bars, hard by one of them
      for (int j = 0; j < model.layout.rollers; ++j)
        y[static_cast<std::size_t>(model.layout.position(kRadius, j))] += 1.8e-3;
      y[static_cast<std::size_t>(model.layout.border_position(kCagePhi))] += 0.3e-3 / 19.5e-3;
    } else if (apart.place > 0) {  // onto the lands of one ring, then of the other
      y[static_cast<std::size_t>(model.layout.border_position(kCageY))] =
          model.guides[apart.speed == 3 ? 1 : 0].clearance + 30e-6;
      y[static_cast<std::size_t>(model.layout.border_position(kCageZ))] = 0;
      if (apart.speed == 12) {  // pressed on them, between the speeds of static and full sliding
        const auto first = y.begin() + model.layout.border_velocity(0);
        std::fill(first, first + model.layout.border(), 0.0);
        y[static_cast<std::size_t>(model.layout.border_velocity(kCagePhi))] =
            0.4 / model.pitch_radius;
      }
    }
    for (const double t : {0.0, 0.3e-3}) {
      EXPECT_TRUE(system.linearise_at(t, y.data()));
      print.insert(print.end(), system.rate.begin(), system.rate.end());
      print.insert(print.end(), system.seen.lost.begin(), system.seen.lost.end());
      print.push_back(system.seen.elastic_energy);
    }
  }
  return print;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  return true;
}

/// Other values of the key, within its range: of choices all, else one.
std::vector<Scene> altered(const Key<Scene>& key, const Scene& from) {
  Scene scene = from;
  const bool geometry = key.unit == "mm" && !key.name.starts_with("contact.");
  const auto number = [&](double old) {
    const double minimum = std::isfinite(key.range.minimum) ? key.range.minimum : 0;
    if (key.name == "cage.face_radius_mm") return 2 * unit_value(from.roller.diameter[0], 1e-3);
    double changed = std::isnan(old) ? std::max(minimum, 0.0) + 0.37
                     : old == 0      ? 1
                                     : (geometry ? 1.002 : 1.3) * old;
    if (changed > key.range.maximum)
      changed = old == key.range.maximum ? 0.97 * old : key.range.maximum;
    return changed;
  };
  switch (key.kind) {
    case KeyKind::number:
    case KeyKind::numbers: {
      auto values = key_numbers(key, scene);
      for (double& value : values) value = number(value);
      set_key_numbers(key, values, scene);
      break;
    }
    case KeyKind::integer: {
      auto& value = std::get<std::function<long&(Scene&)>>(key.place)(scene);
      value += value + 1 <= key.range.maximum ? 1 : -1;
      break;
    }
    case KeyKind::boolean: {
      auto& value = std::get<std::function<bool&(Scene&)>>(key.place)(scene);
      value = !value;
      break;
    }
    case KeyKind::list: {
      auto& list = std::get<std::function<NumberList&(Scene&)>>(key.place)(scene);
      if (list.empty()) return {};  // tables are given as a whole
      for (double& value : list.values) value = value == 0 ? key.to_si : 1.3 * value;
      break;
    }
    case KeyKind::names:
      return {};
    case KeyKind::choice:
    case KeyKind::text: {
      std::vector<Scene> all;
      for (const std::string& choice : key.range.choices) {
        if ('"' + choice + '"' == key_text(key, from)) continue;
        if (const auto* place = std::get_if<ChoicePlace<Scene>>(&key.place))
          place->set(scene, choice);
        else
          std::get<std::function<std::string&(Scene&)>>(key.place)(scene) = choice;
        all.push_back(scene);
      }
      return all;
    }
  }
  return {scene};
}

/// Keys whose work this test does not see: titles, watches, budgets, what is written, the choice of
/// an elastic cage, whose finite elements take too long here, and of equilibria the pockets, which
/// may only jam; and a heat balance, which runs the bearing itself.
bool elsewhere(const Scene& scene, const std::string& key) {
  if (is_quasi_static(scene) && (key == "cage.pocket_width_mm" || key == "cage.pocket_length_mm"))
    return true;
  static const std::set<std::string> names = {
      "name",       "integration.step_budget", "integration.wall_budget_s",
      "cage.model", "cage.allow_interference", "window.history_interval_us",
      "duty.file",  "temperature.balance"};
  return names.count(key) || key.starts_with("watch.");
}

struct Case {
  std::string name;
  void (*set)(Scene&);
};

class IdleKeys : public testing::TestWithParam<Case> {};

TEST_P(IdleKeys, AreThoseThatChangeNothing) {
  Scene scene = shipped_scene("nu205");
  scene.start.state = StartState::equilibrium;  // found sooner than the steady one
  scene.bearing.ring_material = scene.roller.material = {"bearing-steel"};
  scene.cage.material = {"steel-q235"};
  scene.bearing.inner_flange_diameter = 34.7e-3;  // for the choices of inner_flanges
  scene.lubrication.viscosity_40 = 68;
  scene.lubrication.viscosity_100 = 8.7;
  GetParam().set(scene);
  const auto before = fingerprint(scene);
  ASSERT_TRUE(same(before, fingerprint(scene)));
  for (const auto& key : scene_keys()) {
    if (elsewhere(scene, key.name)) continue;
    const std::vector<Scene> others = altered(key, scene);
    if (others.empty()) continue;  // a choice of one
    SCOPED_TRACE(key.name + " = " + key_text(key, scene));
    ASSERT_NE(key_text(key, others.front()), key_text(key, scene));
    const std::string why = std::string(why_idle(scene_keys(), key, scene));
    const bool changed = std::any_of(others.begin(), others.end(), [&](const Scene& other) {
      return !same(before, fingerprint(other));
    });
    EXPECT_EQ(why.empty(), changed)
        << key.name << " = " << key_text(key, scene)
        << (changed ? " does something but is said to do nothing: " + why
                    : std::string(" does nothing"));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, IdleKeys,
    testing::Values(
        Case{"oiled", [](Scene&) {}},
        Case{"dry", [](Scene& s) { s.lubrication.model = LubricationModel::none; }},
        Case{"impact",
             [](Scene& s) {
               s.lubrication.model = LubricationModel::none;
               s.contact.race.law = s.contact.bar.law = ForceLaw::impact;
             }},
        Case{"tilting",
             [](Scene& s) {
               s.lubrication.model = LubricationModel::none;
               s.model.ring_tilt = TiltModel::free;
             }},
        Case{"with_ramps",
             [](Scene& s) {
               s.lubrication.model = LubricationModel::none;
               s.operation.load_ramp = 1e-3;
               s.operation.speed_ramp_from = 100;
               s.operation.speed_ramp = 1e-3;
             }},
        Case{"under_a_duty",
             [](Scene& s) {
               s.operation.table.time = {{0, 100e-6}};
               s.operation.table.radial_load = {{1000, 3000}};
               s.operation.table.direction = {{0, 1}};
               s.operation.table.outer_speed = {{0, -20}};
               s.operation.table.repeat = 120e-6;
             }},
        Case{"rollers_guide",
             [](Scene& s) {
               s.cage.guidance = Guidance::roller;
               s.cage.retention_outer = {
                   retention_width(s.cage, pitch_radius(s.bearing), 3.75e-3, 1, 0.1e-3)};
             }},
        Case{"sphere_ends",
             [](Scene& s) {
               s.roller.end_radius = 0.4;
               s.bearing.outer_flange_angle = 2.45e-3 / 0.4;
             }},
        Case{"dry_sphere_ends_of_both_rings",
             [](Scene& s) {
               s.lubrication.model = LubricationModel::none;
               s.bearing.inner_flanges = FlangeSides::both;
               s.roller.end_radius = 0.4;
               s.bearing.outer_flange_angle = 2.45e-3 / 0.4;
               s.bearing.inner_flange_angle = 2.7e-3 / 0.4;
             }},
        Case{"wavy",
             [](Scene& s) {
               s.bearing.inner_waviness[0].amplitude = 3e-6;
               s.bearing.outer_waviness[1] = {2e-6, 5, 0.4};
             }},
        Case{"wavy_equilibria",
             [](Scene& s) {
               s.model.motion = MotionModel::quasi_static;
               s.bearing.inner_waviness[1].amplitude = 3e-6;
               s.bearing.outer_waviness[0].amplitude = 2e-6;
             }},
        Case{"polymer", [](Scene& s) { s.cage.material = {"pa66-gf25"}; }},
        Case{"given_materials",
             [](Scene& s) {
               s.bearing.ring_material = s.roller.material = {"bearing-steel", 208e9, 0.3, 7810};
               s.cage.material = {"steel-q235", 206e9, 0.3, 7850};
               s.contact.race_approach = RaceApproach::line;
             }},
        Case{"fitted",
             [](Scene& s) {
               s.fit.inner_interference = s.fit.outer_interference = 15e-6;
               s.fit.housing_diameter = 90e-3;
               s.temperature.growth = true;
               s.operation.centrifugal_growth = true;
             }},
        Case{"fitted_outer_ring_turns",
             [](Scene& s) {
               s.operation.outer_speed = -10;  // lands slide below the speed of full sliding
               s.fit.inner_interference = s.fit.outer_interference = 15e-6;
               s.fit.housing_diameter = 90e-3;
               s.operation.centrifugal_growth = true;
             }},
        Case{"fitted_equilibria",
             [](Scene& s) {
               s.model.motion = MotionModel::quasi_static;
               s.fit.inner_interference = s.fit.outer_interference = 15e-6;
               s.fit.housing_diameter = 90e-3;
               s.operation.centrifugal_growth = true;
             }},
        Case{"warm_loose_rings",
             [](Scene& s) {
               s.lubrication.model = LubricationModel::none;
               s.temperature.growth = true;
             }},
        Case{"oiled_equilibria", [](Scene& s) { s.model.motion = MotionModel::quasi_static; }},
        Case{"equilibria",
             [](Scene& s) {
               s.lubrication.model = LubricationModel::none;
               s.model.motion = MotionModel::quasi_static;
             }}),
    [](const auto& one) { return one.param.name; });

TEST(IdleNotes, NameReasonAndKeysOnce) {
  Scene scene;
  EXPECT_THAT(idle_notes(scene), IsEmpty());
  scene.cage.modes = 12;
  scene.cage.mesh_density = 3;
  scene.lubrication.squeeze = false;
  EXPECT_THAT(idle_notes(scene),
              ElementsAre("without effect (cage.model = \"rigid\"): cage.modes, cage.mesh_density",
                          "without effect (lubrication.model = \"none\"): lubrication.squeeze"));
}

// Catalogue values are for rating life and warnings: given ones are no mistake, varied ones are.
TEST(IdleNotes, NameCatalogueValuesOnlyWhereTheyVary) {
  Scene scene;
  scene.bearing.dynamic_rating = 28.6e3;
  scene.bearing.limiting_speed = 1600;
  EXPECT_THAT(idle_notes(scene), IsEmpty());
  const auto varies = [](const std::string& key) { return key == "bearing.dynamic_rating_kN"; };
  EXPECT_THAT(idle_notes(scene, varies),
              ElementsAre("without effect (rating life and warnings alone depend on it, no "
                          "simulated result): bearing.dynamic_rating_kN"));
}

TEST(Materials, FillWhatIsNotGiven) {
  Scene scene;
  EXPECT_EQ(cage_material(scene).young, 206e9);
  scene.cage.material = {"pa66-gf25"};
  scene.lubrication.temperature = 75;
  EXPECT_NEAR(cage_material(scene).young, 4.05e9, 1e6);  // half-way between 60 and 90 degC
  scene.cage.temperature = 200;                          // beyond the table: its last value
  EXPECT_NEAR(cage_material(scene).young, 2.9e9, 1e6);
  EXPECT_EQ(mode_damping(scene.cage), 0.03);
  scene.cage.material.young = 3e9;
  scene.cage.mode_damping = 0.2;
  EXPECT_EQ(cage_material(scene).young, 3e9);
  EXPECT_EQ(cage_material(scene).density, 1320);
  EXPECT_EQ(mode_damping(scene.cage), 0.2);
}

/// The pair's own E' acts: forces of bars and races at a given depth, dry.
TEST(Materials, ActInTheContacts) {
  const auto bar = [](const MaterialChoice& roller, const MaterialChoice& cage) {
    Scene scene;
    scene.roller.material = roller;
    scene.cage.material = cage;
    return make_bearing_model(scene).bar.stiffness;
  };
  const auto race = [](const MaterialChoice& roller) {
    Scene scene;
    scene.roller.material = roller;
    return make_bearing_model(scene).race.stiffness;
  };
  const MaterialChoice steel{"bearing-steel"}, ceramic{"silicon-nitride"};
  // 2/(0.91/208 + (1 - 0.26^2)/310) = 270.9 GPa against 228.6 GPa
  EXPECT_NEAR(race(ceramic) / race(steel), 270.9 / 228.57, 2e-4);
  EXPECT_NEAR(bar(steel, {"bearing-steel"}), race(steel) * 5 / 3, 1e-9 * race(steel));
  // 2/(0.91/208 + (1 - 0.34^2)/102) = 153.3 GPa
  EXPECT_NEAR(bar(steel, {"brass-cuzn40pb2"}) / bar(steel, steel), 153.3 / 228.57, 2e-4);
  EXPECT_LT(bar(steel, {"peek-cf30"}), 0.25 * bar(steel, steel));
}

}  // namespace
}  // namespace cagetol
