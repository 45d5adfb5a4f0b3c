#include "src/statics/steady_start.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>

#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kPerRpm = 2 * std::numbers::pi / 60;

Scene oiled(double load) {
  Scene scene = shipped_scene("nu205");
  scene.lubrication.model = LubricationModel::film;
  scene.lubrication.viscosity = 0.02;
  scene.operation.radial_load = load;
  return scene;
}

double slip(const BearingModel& m, const SteadyStart& start) {
  return 1 - start.turn.cage_speed / kinematic_cage_speed(m, ring_speeds_at(m.duty, 0));
}

TEST(CageRest, OnDryLandsLeansByTheAngleOfFriction) {
  Scene scene = oiled(1000);
  scene.lubrication.land_film = false;
  const BearingModel m = make_bearing_model(scene);
  const double mu = scene.contact.friction_dynamic, push = 3;  // slides far beyond dynamic_speed
  const CageRest rest = cage_rest(m, 250, {}, 0, -push);
  const double normal = push / std::hypot(1, mu);
  const double depth = 2 * (std::hypot(rest.y, rest.z) - m.guide_clearance);  // of both lands
  EXPECT_GT(depth, 0);
  EXPECT_LT(depth, 1e-6);
  EXPECT_NEAR(rest.torque, -mu * normal * m.guides[0].land_radius, 1e-9);
  // Friction pushes the turning cage's lowest point backwards: it climbs ahead.
  EXPECT_NEAR(std::atan2(rest.y, -rest.z), -std::atan(mu), 1e-9);
}

TEST(CageRest, NowhereWhereRollersGuide) {
  Scene scene = oiled(1000);
  scene.cage.guidance = Guidance::roller;
  const CageRest rest = cage_rest(make_bearing_model(scene), 250, {}, 1, 1);
  EXPECT_EQ(rest.torque, 0);
  EXPECT_EQ(rest.y, 0);
}

TEST(SteadyStart, BalancesTheTorquesOnTheCage) {
  for (const double load : {0.0, 50.0, 150.0, 300.0, 1000.0, 10000.0}) {
    const BearingModel m = make_bearing_model(oiled(load));
    const SteadyStart start = find_steady_start(m);
    ASSERT_TRUE(start.found) << load;
    // A little slower and faster they drive and brake it: it is a stable state.
    const auto torque = [&](double share) {
      RollerOrbit orbit(m);
      EXPECT_TRUE(orbit.solve(share * start.turn.cage_speed));
      const OrbitTurn& t = orbit.turn();
      return t.torque + cage_churning(m.churning, t.cage_speed, m.duty.speed.inner, 0).cage +
             cage_rest(m, t.cage_speed, {}, t.force_y, t.force_z - m.cage_mass * m.gravity).torque;
    };
    EXPECT_GT(torque(0.999), 0) << load;
    EXPECT_LT(torque(1.001), 0) << load;
  }
}

TEST(SteadyStart, SlipFallsWithTheLoad) {
  double before = 1;
  for (const double load : {20.0, 50.0, 100.0, 200.0, 450.0, 1000.0}) {
    const BearingModel m = make_bearing_model(oiled(load));
    const SteadyStart start = find_steady_start(m);
    ASSERT_TRUE(start.found) << load;
    EXPECT_LT(slip(m, start), before) << load;
    before = slip(m, start);
    if (load == 20) {
      EXPECT_GT(before, 0.5);
    }
  }
  EXPECT_LT(before, 0.015);
}

TEST(SteadyStart, OfASkiddingBearingStaysWhereItStarts) {
  Scene scene = oiled(100);
  scene.window.settle_revolutions = 1;
  scene.window.measure_revolutions = 3;
  const BearingModel m = make_bearing_model(scene);
  const SteadyStart start = find_steady_start(m);
  ASSERT_TRUE(start.found);
  EXPECT_GT(slip(m, start), 0.05);
  const Outcome run = simulate(scene);
  ASSERT_EQ(run.status, Status::ok) << run.reason;
  EXPECT_NEAR(quantity(run, "cage_slip_ratio"), slip(m, start), 0.03);
  scene.start.state = StartState::equilibrium;  // takes longer
  scene.window.longest_settle_revolutions = 0;  // and is not waited for
  EXPECT_LT(quantity(simulate(scene), "cage_slip_ratio"), 0.95 * slip(m, start));
}

TEST(SteadyStart, IsWhatLubricatedBearingsStartFrom) {
  const BearingModel m = make_bearing_model(oiled(50));
  const SteadyStart start = find_steady_start(m);
  ASSERT_TRUE(start.found);
  const std::vector<double> by_itself = start_state(m, {}),
                            steady = start_state(m, {.state = StartState::steady}),
                            rolling = start_state(m, {.state = StartState::equilibrium});
  EXPECT_EQ(by_itself, steady);
  const auto speed = [&](const std::vector<double>& y) {
    return y[static_cast<std::size_t>(m.layout.border_velocity(kCagePhi))];
  };
  EXPECT_EQ(speed(steady), start.turn.cage_speed);
  EXPECT_EQ(speed(rolling), kinematic_cage_speed(m, m.duty.speed));

  const BearingModel dry = make_bearing_model(dry_scene("nu205"));
  EXPECT_FALSE(find_steady_start(dry).found);
  EXPECT_EQ(start_state(dry, {}), start_state(dry, {.state = StartState::equilibrium}));
}

TEST(SteadyStart, LeavesRollersInTheirPockets) {
  Scene scene = oiled(50);
  scene.cage.pocket_width.assign(13, 7.65e-3);
  scene.cage.pocket_width[3] = 7.52e-3;  // a tight one
  scene.start.cage_offset_y = 50e-6;
  const BearingModel m = make_bearing_model(scene);
  const std::vector<double> y = start_state(m, scene.start);
  const StateLayout& l = m.layout;
  int to_one_side = 0;
  for (int j = 0; j < l.rollers; ++j) {
    const double pocket = 2 * std::numbers::pi * j / l.rollers;
    const double r = y[static_cast<std::size_t>(l.position(kRadius, j))],
                 theta = y[static_cast<std::size_t>(l.position(kAngle, j))];
    const double ahead = std::remainder(theta - pocket, 2 * std::numbers::pi) * r +
                         scene.start.cage_offset_y * std::sin(pocket);
    const double play = (each(scene.cage.pocket_width, j) - 7.5e-3) / 2;
    EXPECT_LT(std::abs(ahead), play + 0.5e-6) << j;
    if (std::abs(ahead) > play - m.bar_line.layer) ++to_one_side;
  }
  EXPECT_GT(to_one_side, 6);
}

/// Legal extremes: a start is found or not, never a failure.
struct Extreme {
  const char* name;
  double load, rpm, viscosity, gravity;
};
TEST(SteadyStart, NeverFails) {
  for (const Extreme& e :
       {Extreme{"standstill", 100, 0, 0.02, 9.81}, Extreme{"no load", 0, 6000, 0.02, 9.81},
        Extreme{"no load, no weight", 0, 6000, 0.02, 0}, Extreme{"creeping", 1000, 1, 0.02, 9.81},
        Extreme{"fast", 1000, 30000, 0.02, 9.81}, Extreme{"reversed", 20, -6000, 0.02, 9.81},
        Extreme{"thin", 300, 6000, 0.001, 9.81}, Extreme{"thick", 300, 6000, 1, 9.81},
        Extreme{"thick, no load", 0, 6000, 1, 9.81}, Extreme{"heavy", 30000, 3000, 0.1, 9.81}}) {
    Scene scene = oiled(e.load);
    scene.operation.inner_speed = e.rpm * kPerRpm;
    scene.operation.gravity = e.gravity;
    scene.lubrication.viscosity = e.viscosity;
    for (const Guidance guidance : {Guidance::outer, Guidance::inner, Guidance::roller}) {
      scene.cage.guidance = guidance;
      const BearingModel m = make_bearing_model(scene);
      for (const double y : start_state(m, scene.start)) ASSERT_TRUE(std::isfinite(y)) << e.name;
    }
  }
}

TEST(SteadyStart, BelongsToTheSpeedAtWhichARampBegins) {
  Scene scene = oiled(100);
  scene.operation.speed_ramp = 0.05;
  scene.operation.speed_ramp_from = 3000 * kPerRpm;
  const BearingModel ramped = make_bearing_model(scene);
  scene.operation.speed_ramp = 0;
  scene.operation.inner_speed = 3000 * kPerRpm;
  const BearingModel slow = make_bearing_model(scene);
  EXPECT_EQ(find_steady_start(ramped).turn.cage_speed, find_steady_start(slow).turn.cage_speed);
}

TEST(SteadyStart, OfADryBearingIsRefused) {
  Scene scene = dry_scene("nu205");
  scene.start.state = StartState::steady;
  try {
    check_scene(scene, "dry.toml", nullptr);
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("start.state"), std::string::npos) << text;
    EXPECT_NE(text.find("lubrication.model"), std::string::npos) << text;
  }
  scene.lubrication.model = LubricationModel::film;
  EXPECT_NO_THROW(check_scene(scene, "oiled.toml", nullptr));
}

}  // namespace
}  // namespace cagetol
