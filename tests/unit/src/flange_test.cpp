// Flanges of either ring, and an axial load that rollers carry from one to the other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <array>
#include <cmath>

#include "src/input/input_error.hpp"
#include "src/integration/system.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/reference_scene.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;

/// The NU 205 with a flange on the left of its inner ring: an NJ 205.
Scene nj205() {
  Scene scene = shipped_scene("nu205");
  scene.cage.model = CageKind::rigid;
  scene.bearing.inner_flanges = FlangeSides::left;
  scene.bearing.inner_flange_diameter = 34.7e-3;
  scene.bearing.misalignment_y = scene.bearing.misalignment_z = 0;
  return scene;
}

TEST(Flanges, StandOnTheSidesThatTheSceneSays) {
  Scene scene = nj205();
  BearingModel m = make_bearing_model(scene);
  ASSERT_EQ(m.flanges.size(), 3U);
  EXPECT_FALSE(m.flanges[0].inner || m.flanges[1].inner);
  EXPECT_EQ(m.flanges[0].side, -1);
  EXPECT_EQ(m.flanges[1].side, 1);
  EXPECT_TRUE(m.flanges[2].inner);
  EXPECT_EQ(m.flanges[2].side, -1);
  // Oiled, in the middle between a corner of 0.06 D and the rim: outside the rollers' axes for the
  // outer ring, inside for the inner one.
  const double corner = 0.06 * 7.5e-3, outer_race = scene.bearing.outer_raceway_diameter / 2,
               inner_race = scene.bearing.inner_raceway_diameter / 2;
  EXPECT_NEAR(m.flanges[0].points[0].radial,
              (43.8e-3 / 2 + outer_race - corner) / 2 - m.pitch_radius, 1e-15);
  EXPECT_NEAR(m.flanges[2].points[0].radial,
              (34.7e-3 / 2 + inner_race + corner) / 2 - m.pitch_radius, 1e-15);
  // Dry, at the rim.
  scene.lubrication.end_film = false;
  m = make_bearing_model(scene);
  EXPECT_NEAR(m.flanges[0].points[0].radial, 43.8e-3 / 2 - m.pitch_radius, 1e-15);
  scene.bearing.outer_flanges = FlangeSides::none;
  m = make_bearing_model(scene);
  EXPECT_EQ(m.flanges.size(), 1U);
}

// A cage that the outer ring guides runs on its flanges; without them on the raceway.
TEST(Flanges, AreTheLandsOfACageOrTheRacewayIs) {
  BearingGeometry b;
  EXPECT_EQ(outer_land_diameter(b), 43.8e-3);
  EXPECT_DOUBLE_EQ(inner_land_diameter(b), 31.5e-3 - 15e-6);
  b.outer_flanges = FlangeSides::none;
  b.inner_flanges = FlangeSides::both;
  b.inner_flange_diameter = 34.7e-3;
  EXPECT_DOUBLE_EQ(outer_land_diameter(b), 46.5e-3 + 15e-6);
  EXPECT_EQ(inner_land_diameter(b), 34.7e-3);
}

// Seen in a mirror at x = 0 an NJ with its inner flange on the right, loaded the other way round.
TEST(Flanges, CarryAnAxialLoadEitherWay) {
  double torque[2];
  for (const bool left : {true, false}) {
    Scene scene = nj205();
    if (!left) scene.bearing.inner_flanges = FlangeSides::right;
    scene.operation.axial_load = left ? 200 : -200;
    scene.window.settle_revolutions = 1;
    scene.window.measure_revolutions = 1;
    const Outcome outcome = simulate(scene);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
    torque[left] = quantity(outcome, "friction_torque_Nmm");
    EXPECT_GT(quantity(outcome, "power_flange_W"), 0.1);
  }
  EXPECT_NEAR(torque[0], torque[1], 0.02 * torque[1]);
}

// Rollers between flanges of both rings push the inner one back by what the outer one holds.
TEST(Flanges, BalanceTheAxialLoad) {
  Scene scene = nj205();
  scene.lubrication.end_film = false;  // flanges of both rings then push alike
  scene.operation.axial_load = 300;
  const BearingModel m = make_bearing_model(scene);
  System system(m);
  const std::vector<double> start = start_state(m, scene.start);
  PackVector y(start.begin(), start.end());
  // Rollers stand at the outer flange, the ring's flange at the rollers.
  const double c = scene.bearing.flange_clearance / 2;
  EXPECT_DOUBLE_EQ(y[static_cast<std::size_t>(m.layout.position(kAxial, 0))], c);
  const auto axial = static_cast<std::size_t>(m.layout.border_position(m.layout.ring_axial_slot()));
  EXPECT_DOUBLE_EQ(y[axial], 2 * c);
  // Pressed together by a micrometre on each side, rollers are in balance but for friction, and the
  // ring is pushed back by as much as the outer flange holds.
  y[axial] += 2e-6;
  for (int j = 0; j < m.layout.rollers; ++j) {
    y[static_cast<std::size_t>(m.layout.position(kAxial, j))] += 1e-6;
    y[static_cast<std::size_t>(m.layout.position(kAxisY, j))] = 0;
    y[static_cast<std::size_t>(m.layout.position(kAxisZ, j))] = 0;
  }
  ASSERT_TRUE(system.linearise_at(0, y.data()));
  double pressed = 0;
  for (int j = 0; j < m.layout.rollers; ++j)
    pressed += system.seen.flange_force[static_cast<std::size_t>(j)];
  const double pushed =
      system.rate[static_cast<std::size_t>(m.layout.border_velocity(m.layout.ring_axial_slot()))] *
          m.ring_mass -
      load_at(m.duty, 0).axial;
  EXPECT_GT(pressed, 10);
  EXPECT_NEAR(-pushed, pressed / 2, 0.01 * pressed);
}

// What an axial load adds to the friction torque, and what flanges take: the term of SKF's friction
// model at its coefficient of a full film, S1 d_m^0.9 F_a mu, S1 = 0.16 for this series, mu = 0.02.
// Friction of a film whose wedge carries grows with the root of the load: at a sixth of this load
// flanges take three times the maker's term. Source: SKF rolling bearings catalogue 17000,
// frictional moment, table 1c.
TEST(Flanges, RubAsTheMakerSays) {
  Scene scene = shipped_scene("nj308-axial");
  scene.cage.model = CageKind::rigid;
  const auto run = [&](double axial) {
    scene.operation.axial_load = -axial;
    const Outcome outcome = simulate(scene);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
    return std::array{
        quantity(outcome, "friction_torque_Nmm"),
        1e3 * quantity(outcome, "power_flange_W") / std::abs(scene.operation.inner_speed)};
  };
  const double maker = 0.16 * std::pow(65, 0.9) * 600 * 0.02;
  const auto unloaded = run(0), loaded = run(600);
  for (const double torque : {loaded[0] - unloaded[0], loaded[1] - unloaded[1]}) {
    EXPECT_GT(torque, maker / 1.6);
    EXPECT_LT(torque, maker * 1.6);
  }
}

TEST(Flanges, ThatAreMissingAreNamed) {
  const auto refused = [](const std::string& overrides) -> std::string {
    try {
      read_scene(reference_scene_table(overrides, "t.toml"), "t.toml");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refused("[bearing]\nouter_flanges = \"left\"\n"),
              HasSubstr("no flange holds the rollers on the right"));
  EXPECT_THAT(refused("[bearing]\ninner_flanges = \"left\"\n"),
              HasSubstr("inner_flange_diameter_mm"));
  EXPECT_THAT(refused("[lubrication]\nmodel = \"film\"\n[roller]\ncorner_radius_mm = 2\n"),
              HasSubstr("do not reach past the rollers' corners"));
  EXPECT_THAT(refused("[load]\naxial_N = 100\n"),
              HasSubstr("a flange of the inner ring on the left"));
}

}  // namespace
}  // namespace cagetol
