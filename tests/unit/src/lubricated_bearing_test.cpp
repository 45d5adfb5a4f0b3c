// The program's planar, lubricated bearing against the reference that is written from the equations
// alone: one contact, one state of the bearing by mechanism, what the rolling resistance does to a
// pair of bodies; and lanes of pockets that do not depend on each other.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "src/contact_laws/normal_force.hpp"
#include "src/integration/system.hpp"
#include "src/lubrication/lubricated_line.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/planar_scene.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

class LubricatedBearing : public testing::Test {
 protected:
  double about(double size) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  /// Of every size between the two.
  double between(double low, double high) {
    return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(engine_));
  }

 private:
  std::mt19937_64 engine_{38};
};

TEST_F(LubricatedBearing, OneContactIsTheReferencesContact) {
  PlanarBearing bearing;
  bearing.oil.outer_layer = 50e-6;
  bearing.chi = hunt_crossley_chi(0.9, 0.1);
  Scene scene = planar_scene(bearing);
  scene.contact.race.restitution = scene.contact.bar.restitution = 0.9;
  const BearingModel model = make_bearing_model(scene);
  struct Pair {
    const LubricatedLine* law;
    PlanarContact reference;
  };
  const Pair pairs[] = {{&model.inner_line, inner_race_contact(bearing)},
                        {&model.outer_line, outer_race_contact(bearing)},
                        {&model.bar_line, bar_contact(bearing)}};
  for (const Pair& pair : pairs)
    for (int i = 0; i < 2000; ++i) {
      const double gap = i % 2 == 0 ? about(20e-6) : about(1e-6);
      const double rate = about(i % 3 == 0 ? 0.1 : 1e-3);
      const double u = about(i % 5 == 0 ? 0.05 : 20), sliding = between(1e-4, 5);
      const auto ours =
          line_forces<double>(*pair.law, line_speed(*pair.law, u), gap, rate, sliding * sliding);
      const PlanarContactForces due = contact_forces(pair.reference, gap, rate, u, sliding);
      const auto same = [&](double value, double expected, double scale, const char* what) {
        EXPECT_NEAR(value, expected, 1e-6 * std::abs(expected) + scale)
            << what << ", gap " << gap << ", rate " << rate << ", u " << u;
      };
      same(ours.at.normal, due.normal, 1e-9, "normal force");
      same(ours.at.steady, due.steady, 1e-9, "steady film");
      same(ours.at.film, due.film, 1e-9, "film with squeeze");
      same(ours.rolling, due.rolling, 1e-9, "rolling force");
      same(ours.at.oil.thickness, due.thickness > 0 ? due.thickness : ours.at.oil.thickness, 1e-15,
           "film thickness");
      if (due.normal > 1e-3) same(ours.ratio * sliding, due.traction, 1e-9, "traction");
    }
}

// What makes the comparison with a planar reference a fair one.
TEST(PlanarScene, NothingMovesRollersOutOfThePlane) {
  Scene scene = planar_scene({});
  scene.window.settle_time = 0;
  scene.window.measure_time = 5e-3;
  scene.watch.static_consistency_max = 1;  // too brief to settle
  double most = 0, turned = 0;
  const Outcome outcome =
      simulate(scene, {.on_state = [&](double, const double* y, const System& system) {
                 const StateLayout& l = system.model.layout;
                 most = std::max(most, out_of_plane(l, y));
                 turned = y[l.border_position(kCagePhi)];
               }});
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_EQ(most, 0);
  EXPECT_GT(turned, 1);
  EXPECT_GT(quantity(outcome, "pocket_force_peak_N"), 0.1);
}

/// A random state of the program and the same one for the reference.
struct State {
  std::vector<double> y;
  std::vector<PlanarBody> rollers;
  std::vector<double> pockets;
  PlanarBody ring;
  double cage_speed;
};

TEST_F(LubricatedBearing, ForcesOfAStateAgreeMechanismByMechanism) {
  const PlanarBearing bearing;
  const BearingModel model = make_bearing_model(planar_scene(bearing));
  const StateLayout& l = model.layout;
  System system(model);
  const double orbit = kinematic_speed(bearing), mass = model.groups[0].mass[0],
               Rw = bearing.roller_radius;
  double moved[3] = {0, 0, 0};
  for (int trial = 0; trial < 40; ++trial) {
    std::vector<double> y = start_state(model, {});
    const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
    // A skidding cage, sliding rollers that touch their bars.
    const double phase = about(3), turning = orbit * (1 - between(1e-3, 0.8));
    PlanarBody ring{about(15e-6), about(15e-6), about(0.05), about(0.05), bearing.inner_speed};
    at(l.border_position(kRingY)) = ring.y;
    at(l.border_position(kRingZ)) = ring.z;
    at(l.border_velocity(kRingY)) = ring.vy;
    at(l.border_velocity(kRingZ)) = ring.vz;
    at(l.border_position(kCagePhi)) = phase;
    at(l.border_velocity(kCagePhi)) = turning;
    std::vector<PlanarRollerForces> due;
    for (int j = 0; j < l.rollers; ++j) {
      const double pocket = phase + 2 * pi * j / l.rollers;
      const double off = bearing.half_clearance - (j % 3 == 0 ? about(3e-6) : between(1e-6, 50e-6));
      const double angle = pocket + (j % 2 == 0 ? off : -off) / model.pitch_radius;
      const double r = model.pitch_radius + about(15e-6), v_r = about(0.05);
      const double omega = turning + about(0.5) / r;
      const double spin =
          (r * orbit - bearing.inner_radius * bearing.inner_speed) / Rw * between(0.2, 1.1);
      at(l.position(kRadius, j)) = r;
      at(l.position(kAngle, j)) = angle;
      at(l.velocity(kRadialSpeed, j)) = v_r;
      at(l.velocity(kOrbitRate, j)) = omega;
      at(l.velocity(kSpin, j)) = spin;
      const double c = std::cos(angle), s = std::sin(angle), v_t = r * omega;
      due.push_back(roller_forces(bearing, ring,
                                  {r * c, r * s, v_r * c - v_t * s, v_r * s + v_t * c, spin},
                                  pocket, turning));
    }
    ASSERT_TRUE(system.linearise_at(0, y.data()));
    const auto rate = [&](int slot) { return system.rate[static_cast<std::size_t>(slot)]; };
    PlanarLosses losses;
    double film = 0, ring_y = 0, ring_z = 0, on_cage = 0, drive = 0, heavy = 0, driven = 0,
           barred = 0;
    for (int j = 0; j < l.rollers; ++j) {
      const PlanarRollerForces& f = due[static_cast<std::size_t>(j)];
      const double r = at(l.position(kRadius, j)), angle = at(l.position(kAngle, j)),
                   omega = at(l.velocity(kOrbitRate, j)), v_r = at(l.velocity(kRadialSpeed, j));
      const double c = std::cos(angle), s = std::sin(angle);
      const double F_r = f.y * c + f.z * s, F_t = f.z * c - f.y * s;
      const double normals = f.inner + f.outer, bars = f.bar[0] + f.bar[1];
      const auto size = [](const PlanarContactForces& x) {
        return std::abs(x.traction) + std::abs(x.rolling);
      };
      const double along = size(f.inner_contact) + size(f.outer_contact);
      // Levers of films count the gap as nothing beside the radii, here up to 2e-3 of them.
      const auto same = [&](double ours, double theirs, double scale, const char* what) {
        EXPECT_NEAR(ours, theirs, scale) << what << ", trial " << trial << ", roller " << j;
      };
      same(mass * (rate(l.velocity(kRadialSpeed, j)) - r * omega * omega), F_r,
           1e-3 * (normals + bars) + 2e-3, "radial");
      same(mass * (r * rate(l.velocity(kOrbitRate, j)) + 2 * v_r * omega), F_t,
           3e-3 * along + 1e-3 * (bars + normals), "along the orbit");
      same(rate(l.velocity(kSpin, j)) / model.groups[0].inverse_polar[0] / Rw, f.moment / Rw,
           3e-3 * (along + size(f.bar_contacts[0]) + size(f.bar_contacts[1])), "spin");
      moved[0] += normals, moved[1] += along, moved[2] += bars;
      ring_y += f.ring_y, ring_z += f.ring_z, on_cage += f.cage_moment;
      drive -= f.ring_moment * bearing.inner_speed;
      heavy += normals, driven += along, barred += bars;
      losses.rolling += f.losses.rolling;
      losses.sliding += f.losses.sliding;
      losses.pocket += f.losses.pocket;
      losses.squeeze += f.losses.squeeze;
      film -= f.film;
    }
    const double ring_mass = model.ring_mass;
    EXPECT_NEAR(ring_mass * rate(l.border_velocity(kRingY)), ring_y, 1e-3 * heavy);
    EXPECT_NEAR(ring_mass * rate(l.border_velocity(kRingZ)) + bearing.load, ring_z, 1e-3 * heavy);
    EXPECT_NEAR(bearing.cage_inertia * rate(l.border_velocity(kCagePhi)) / model.pitch_radius,
                on_cage / model.pitch_radius, 1e-3 * barred);
    const auto share = [&](double ours, double theirs, const char* what) {
      EXPECT_NEAR(ours, theirs, 2e-3 * std::abs(theirs)) << what << ", trial " << trial;
    };
    const Observation& seen = system.seen;
    share(seen.lost[kRollingResistance], losses.rolling, "rolling");
    share(seen.lost[kRaceSliding], losses.sliding, "sliding");
    share(seen.lost[kPocketFriction], losses.pocket, "pockets");
    share(seen.lost[kSqueeze], losses.squeeze, "squeeze");
    EXPECT_NEAR(seen.drive_power, drive,
                2e-3 * driven * bearing.inner_speed * bearing.inner_radius);
  }
  // Of everything there was enough to see.
  for (const double sum : moved) EXPECT_GT(sum, 500);
}

/// What rolling resistance of one kind of contact adds to the rates of a state, times the masses.
struct Added {
  std::vector<double> r, t, moment;  ///< on each roller
  double ring[2] = {0, 0}, cage[2] = {0, 0}, cage_moment = 0;
  double power = 0, drive = 0;  ///< what it dissipates, what it takes from the turning ring
};
Added added_by_rolling(const BearingModel& dry, LubricatedLine BearingModel::*line,
                       const std::vector<double>& y) {
  BearingModel rolls = dry;
  (rolls.*line).rolls = true;
  System with(rolls), without(dry);
  EXPECT_TRUE(with.linearise_at(0, y.data()) && without.linearise_at(0, y.data()));
  const StateLayout& l = dry.layout;
  const auto change = [&](int slot) {
    return with.rate[static_cast<std::size_t>(slot)] - without.rate[static_cast<std::size_t>(slot)];
  };
  Added a;
  const RollerGroup& roller = dry.groups[0];
  for (int j = 0; j < l.rollers; ++j) {
    const double radius = y[static_cast<std::size_t>(l.position(kRadius, j))];
    a.r.push_back(roller.mass[0] * change(l.velocity(kRadialSpeed, j)));
    a.t.push_back(roller.mass[0] * radius * change(l.velocity(kOrbitRate, j)));
    a.moment.push_back(change(l.velocity(kSpin, j)) / roller.inverse_polar[0]);
  }
  for (int k = 0; k < 2; ++k) {
    a.ring[k] = dry.ring_mass * change(l.border_velocity(kRingY + k));
    a.cage[k] = dry.cage_mass * change(l.border_velocity(kCageY + k));
  }
  a.cage_moment = dry.cage_polar * change(l.border_velocity(kCagePhi));
  a.power = with.seen.friction_power - without.seen.friction_power;
  a.drive = with.seen.drive_power - without.seen.drive_power;
  return a;
}

// Momentum and power of rolling resistance, through the program's own right-hand side.
TEST_F(LubricatedBearing, RollingForcesOfAPairSumToZeroAndTakeTwiceForceTimesSpeed) {
  PlanarBearing bearing;
  Scene scene = planar_scene(bearing);
  scene.lubrication.rolling_resistance = false;
  scene.cage.mass = 0.05;
  const BearingModel model = make_bearing_model(scene);
  const StateLayout& l = model.layout;
  std::vector<double> y = start_state(model, {});
  const auto at = [&](int slot) -> double& { return y[static_cast<std::size_t>(slot)]; };
  at(l.border_velocity(kRingY)) = 0.02;
  at(l.border_velocity(kCageZ)) = -0.01;
  for (int j = 0; j < l.rollers; ++j) {
    at(l.position(kRadius, j)) += about(2e-6);
    at(l.position(kAngle, j)) += (bearing.half_clearance - 4e-6) / model.pitch_radius;
    at(l.velocity(kRadialSpeed, j)) = about(0.01);
    at(l.velocity(kOrbitRate, j)) *= between(0.5, 1.1);
    at(l.velocity(kSpin, j)) *= between(0.5, 1.1);
  }
  const double Rw = bearing.roller_radius, orbit = at(l.border_velocity(kCagePhi));
  for (const auto line :
       {&BearingModel::inner_line, &BearingModel::outer_line, &BearingModel::bar_line}) {
    const bool inner = line == &BearingModel::inner_line, bar = line == &BearingModel::bar_line;
    const Added a = added_by_rolling(model, line, y);
    const double R = (inner ? inner_race_contact(bearing) : outer_race_contact(bearing)).radius;
    double sum[2] = {0, 0}, size = 0, turned = 0, into = -a.drive, lost = 0;
    for (int j = 0; j < l.rollers; ++j) {
      const auto i = static_cast<std::size_t>(j);
      const double angle = at(l.position(kAngle, j)), c = std::cos(angle), s = std::sin(angle);
      const double r = at(l.position(kRadius, j)), omega = at(l.velocity(kOrbitRate, j)),
                   spin = at(l.velocity(kSpin, j));
      const double f = a.moment[i] / Rw;  // positive: against the spin, which is negative
      sum[0] += a.r[i] * c - a.t[i] * s;
      sum[1] += a.r[i] * s + a.t[i] * c;
      turned += r * a.t[i];
      size += std::abs(f);
      into += a.r[i] * at(l.velocity(kRadialSpeed, j)) + a.t[i] * r * omega + a.moment[i] * spin;
      const double relative = omega - (bar ? orbit : spin);
      const double u =
          inner ? ((omega - spin) * Rw + (bearing.inner_speed - omega) * bearing.inner_radius) / 2
          : bar ? (orbit - spin) * Rw / 2
                : (relative * Rw + omega * bearing.outer_radius) / 2;
      lost += 2 * f * u;
      if (bar) continue;
      // Along the orbit at the inner race, against it at the outer.
      EXPECT_NEAR(a.t[i], (inner ? 1 : -1) * f * (2 * R / Rw - 1), 5e-3 * f) << j;
    }
    EXPECT_GT(size, 0.1);
    for (int k = 0; k < 2; ++k) {
      if (inner) {
        EXPECT_NEAR(a.ring[k] + sum[k], 0, 1e-9 * size);
      }
      if (bar) {
        EXPECT_NEAR(a.cage[k] + sum[k], 0, 1e-9 * size);
      }
      into += a.ring[k] * at(l.border_velocity(kRingY + k)) +
              a.cage[k] * at(l.border_velocity(kCageY + k));
    }
    into += a.cage_moment * orbit;
    // What the bodies lose, and what the account says they lose.
    EXPECT_NEAR(into, -a.power, 1e-3 * a.power);
    EXPECT_NEAR(a.power, lost, 3e-3 * lost);
    if (bar) {
      double spun = 0;
      for (const double moment : a.moment) spun += moment;
      EXPECT_NEAR(turned + spun + a.cage_moment, 0, 1e-4 * size * model.pitch_radius);
    }
  }
}

/// Rates of the reference bearing with one pocket of its own width, the other rollers turned
/// against their pockets by some micrometres, so that bars ahead and behind have oil.
std::vector<double> rates_with(double width) {
  Scene scene = shipped_scene("nu205");
  scene.cage.pocket_width.assign(13, 7.65e-3);
  scene.cage.pocket_width[3] = width;
  scene.start.state = StartState::equilibrium;
  const BearingModel model = make_bearing_model(scene);
  std::vector<double> y = start_state(model, scene.start), rates(y.size());
  for (int j = 0; j < 13; ++j)
    if (j != 3)
      y[static_cast<std::size_t>(model.layout.position(kAngle, j))] +=
          (j % 2 ? 65e-6 : -62e-6) / model.pitch_radius;
  evaluate_rates(model, 0, y.data(), rates.data());
  return rates;
}

// A pocket so tight that its roller has oil at both bars makes its whole pack take one bar after
// the other, where else each lane takes its own.
TEST(LubricatedPocket, NeighboursOfATightPocketFeelTheSame) {
  const std::vector<double> wide = rates_with(7.65e-3), tight = rates_with(7.52e-3);
  const StateLayout layout = make_bearing_model(shipped_scene("nu205")).layout;
  for (int slot = 0; slot < kRollerVelocities; ++slot)
    for (int j = 0; j < 13; ++j) {
      const auto at = static_cast<std::size_t>(layout.velocity(RollerVelocity(slot), j));
      if (j == 3) continue;
      EXPECT_EQ(wide[at], tight[at]) << "slot " << slot << ", roller " << j;
    }
  const auto spin = static_cast<std::size_t>(layout.velocity(kOrbitRate, 3));
  EXPECT_NE(wide[spin], tight[spin]);
}

}  // namespace
}  // namespace cagetol
