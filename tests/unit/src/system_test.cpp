// What a System says of its rates.
#include "src/integration/system.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include "src/integration/integrator.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/random_bearing.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool finite(const RandomBearing& b, const std::vector<double>& y) {
  System system(b.model);
  std::vector<double> rate(y.size());
  return system.rates(b.t, y.data(), rate.data());
}

// Positions' rates by speeds that are none, accelerations one by one by masses that are none: from
// the first pack of the rates to the last.
TEST(System, TellsOfARateThatIsNotFiniteWhereverItStands) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Freedom freedom = seed % 2 == 0 ? Freedom::tilting : Freedom::spatial;  // 26 or 24 packs
    RandomBearing b = random_bearing(seed, {.freedom = freedom});
    const StateLayout& l = b.model.layout;
    ASSERT_TRUE(finite(b, b.y)) << seed;
    const auto without_speed = [&](int component) {
      for (const double value : {kNone, std::numeric_limits<double>::infinity()}) {
        std::vector<double> y = b.y;
        y[static_cast<std::size_t>(component)] = value;
        EXPECT_FALSE(finite(b, y)) << seed << ", " << component;
      }
    };
    const auto without_mass = [&](double& mass) {
      const double known = mass;
      mass = kNone;
      EXPECT_FALSE(finite(b, b.y)) << seed;
      mass = known;
    };
    for (int j = 0; j < l.rollers; ++j) {
      for (int slot = 0; slot < kRollerPositions; ++slot)
        without_speed(l.velocity(static_cast<RollerVelocity>(slot), j));
      RollerGroup& group = b.model.groups[static_cast<std::size_t>(j / kLanes)];
      for (Pack* inverse : {&group.inverse_mass, &group.inverse_transverse, &group.inverse_polar})
        without_mass(reinterpret_cast<double*>(inverse)[j % kLanes]);
    }
    for (int slot = 0; slot < l.border(); ++slot) without_speed(l.border_velocity(slot));
    for (double* mass :
         {&b.model.ring_mass, &b.model.cage_mass, &b.model.cage_polar, &b.model.cage_transverse})
      without_mass(*mass);
    if (l.ring_tilt > 0) without_mass(b.model.ring_transverse);
  }
}

BearingModel rigid_model(Scene scene) {
  scene.cage.model = CageKind::rigid;
  return make_bearing_model(OperatingScene(scene));
}

// What the figures of the reference bearing are measured with, and what makes of other bearings the
// same measure: the roller's size, and the raceway's speed where that is high.
TEST(ErrorUnits, AreOfTheBearing) {
  const BearingModel nu205 = rigid_model(shipped_scene("nu205"));
  EXPECT_EQ(error_units(nu205).length, 1e-6);
  EXPECT_EQ(error_units(nu205).speed, 1e-2);
  for (const char* name : {"bore10-small", "nu2322-gearbox", "aero118-outer", "n1014-spindle"}) {
    const Scene scene = shipped_scene(name);
    const BearingModel m = rigid_model(scene);
    const ErrorUnits units = error_units(m);
    EXPECT_NEAR(units.length / m.nominal_diameter, error_units(nu205).length / 7.5e-3, 2e-7)
        << name;
    const double surface = scene.operation.inner_speed * m.inner_radius;
    EXPECT_DOUBLE_EQ(units.speed,
                     std::min({std::max(1e-2, 1e-3 * surface), minimum_static_speed(m)}))
        << name;
  }
  EXPECT_GT(error_units(rigid_model(shipped_scene("aero118-outer"))).speed, 0.05);
}

TEST(ErrorUnits, StayWhileRollersScatterAndSpeedsChange) {
  Scene scene = shipped_scene("n1014-spindle");
  const BearingModel steady = rigid_model(scene);
  scene.roller.diameter.assign(static_cast<std::size_t>(scene.bearing.roller_count),
                               scene.roller.diameter[0]);
  scene.roller.diameter[3] += 1e-6;
  EXPECT_EQ(error_units(rigid_model(scene)).length, error_units(steady).length);
  scene.operation.speed_ramp_from = scene.operation.inner_speed;
  scene.operation.speed_ramp = 0.1;
  scene.operation.inner_speed /= 10;
  EXPECT_EQ(error_units(rigid_model(scene)).speed, error_units(steady).speed);
}

TEST(LargestStep, GrowsWithTheTimeBetweenRollers) {
  Integration keys;
  EXPECT_EQ(largest_step(rigid_model(shipped_scene("nu205")), keys), 50e-6);
  Scene scene = shipped_scene("nu2322-gearbox");
  const BearingModel slow = rigid_model(scene);
  const double cage = kinematic_cage_speed(slow, {scene.operation.inner_speed, 0});
  EXPECT_DOUBLE_EQ(largest_step(slow, keys),
                   2 * std::numbers::pi / (cage * slow.layout.rollers) / 40);
  EXPECT_GT(largest_step(slow, keys), 200e-6);
  keys.max_step = 20e-6;
  EXPECT_EQ(largest_step(slow, keys), 20e-6);
  keys.max_step = kAuto;
  scene.operation.load_ramp = 1e-3;
  EXPECT_EQ(largest_step(rigid_model(scene), keys), 50e-6);
  scene.operation.load_ramp = 0;
  scene.operation.inner_speed = 0;
  EXPECT_EQ(largest_step(rigid_model(scene), keys), 50e-6);
}

// Under pressure the traction of a thin film turns over within nanometres a second: only a far
// smaller difference tells how the rates change with the speed of a ring.
TEST(System, KnowsHowTractionChangesWithTheSpeedOfARing) {
  Scene scene = shipped_scene("nu208-planet");
  scene.cage.model = CageKind::rigid;
  scene.operation.table.time = {{0, 0.02}};
  scene.operation.table.outer_speed = {{10, 42}};
  const BearingModel model = make_bearing_model(scene);
  System system(model);
  const std::vector<double> start = start_state(model, scene.start);
  PackVector y(start.begin(), start.end());
  // To where friction holds rollers at rolling.
  double t = 0;
  const auto integrator = make_integrator(scene.integration, system, t, y.data());
  while (t < 1e-3) {
    ASSERT_TRUE(system.linearise_at(t, y.data()));
    ASSERT_EQ(integrator->step(system, t, y.data(), 1e-3), StepStatus::accepted);
  }
  const double d = 1e-13;
  ASSERT_TRUE(system.linearise_at(t, y.data()));
  PackVector by_time(y.size()), before(y.size()), after(y.size());
  system.rates_by_time(t, y.data(), by_time.data());
  const double later = t + d, earlier = t - d;
  ASSERT_TRUE(system.rates(later, y.data(), after.data()));
  ASSERT_TRUE(system.rates(earlier, y.data(), before.data()));
  double largest = 0;
  for (int j = 0; j < model.layout.rollers; ++j) {
    const auto spin = static_cast<std::size_t>(model.layout.velocity(kSpin, j));
    const double exact = (after[spin] - before[spin]) / (later - earlier);
    largest = std::max(largest, std::abs(exact));
    EXPECT_NEAR(by_time[spin], exact, 0.01 * std::abs(exact) + 1e5) << j;
  }
  EXPECT_GT(largest, 1e8);
}

}  // namespace
}  // namespace cagetol
