// Static load distribution against closed numbers: ISO/TS 16281 line stiffness, l = 10 mm, F = 1000
// N, a roller under the load.
#include "src/statics/static_equilibrium.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <numbers>

#include "src/statics/start_state.hpp"
#include "tests/support/aero_bearing.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

struct Case {
  long rollers;
  double clearance_um, displacement_um, force, displacement_digit, force_digit;
};

class LoadDistribution : public testing::TestWithParam<Case> {};

TEST_P(LoadDistribution, GivesTheNumbersToTheirOwnDigits) {
  const Case& c = GetParam();
  Scene scene;
  scene.bearing.roller_count = c.rollers;
  // So large that the contact's direction does not turn with the ring's displacement, as the closed
  // numbers have it; at a pitch of 0.1 m that turning changes the fifth digit.
  scene.bearing.inner_raceway_diameter = 1.991;
  scene.bearing.outer_raceway_diameter = 2.009;
  scene.bearing.shoulder_diameter = 2.006;
  scene.bearing.internal_clearance = c.clearance_um * 1e-6;
  scene.roller.diameter = {9e-3};
  scene.roller.length = 10e-3;
  scene.operation.gravity = 0;
  for (const long slices : {1L, 5L}) {
    scene.discretisation.race_slices = slices;
    const BearingModel model = make_bearing_model(scene);
    std::vector<double> angle(static_cast<std::size_t>(model.layout.padded()));
    for (std::size_t j = 0; j < angle.size(); ++j)
      angle[j] = -std::numbers::pi / 2 +
                 2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(c.rollers);
    StaticEquilibrium equilibrium(model);
    const StaticState& rest = equilibrium.solve(angle.data(), 0, {0, -1000});
    EXPECT_TRUE(rest.converged);
    EXPECT_NEAR(-rest.ring_z * 1e6, c.displacement_um, c.displacement_digit);
    EXPECT_NEAR(rest.inner_force[0], c.force, c.force_digit);
    EXPECT_NEAR(rest.ring_y, 0, 1e-12);
    EXPECT_EQ(*std::max_element(rest.inner_force.begin(), rest.inner_force.begin() + c.rollers),
              rest.inner_force[0]);
  }
}

INSTANTIATE_TEST_SUITE_P(IsoLineContact, LoadDistribution,
                         testing::Values(Case{10, 0, 2.8200, 408.80, 1e-4, 1e-2},
                                         Case{14, 0, 2.0823, 291.86, 1e-4, 1e-2},
                                         Case{20, 0, 1.5101, 204.23, 1e-4, 1e-2},
                                         Case{14, 20, 13.336, 492.8, 1e-3, 0.1},
                                         Case{14, 40, 23.996, 602.2, 1e-3, 0.1}));

// Eight positions to each pitch of the rollers.
TEST(StaticEquilibrium, IsFoundAtEveryPositionOfTheReferenceBearing) {
  for (const double load : {1.0, 1000.0, 10000.0})
    for (const RollerMotion motion : {RollerMotion::at_rest, RollerMotion::orbiting}) {
      Scene scene = dry_scene("nu205");
      const BearingModel model = make_bearing_model(scene);
      StaticEquilibrium equilibrium(model);
      for (int k = 0; k < 104; ++k) {
        const auto angle = roller_angles(model, 2 * std::numbers::pi * k / 104);
        const StaticState& rest = equilibrium.solve(
            angle.data(), kinematic_cage_speed(model, model.duty.speed), {0, -load}, motion);
        EXPECT_TRUE(rest.converged) << load << " N, position " << k;
      }
    }
}

// Across large clearances the ring first has to find the rollers, and on one of them it stands on a
// hill. Rollers of unequal size, preload and hardly any load are no harder.
TEST(StaticEquilibrium, IsFoundWhateverTheClearanceAndTheLoad) {
  for (const double clearance : {-20e-6, 0.0, 30e-6, 200e-6, 400e-6, 600e-6, 740e-6})
    for (const double load : {0.0, 1.0, 1000.0})
      for (const bool unequal : {false, true}) {
        Scene scene = dry_scene("nu205");
        scene.bearing.internal_clearance = clearance;
        scene.roller.diameter.assign(13, 7.5e-3);
        for (std::size_t j = 0; unequal && j < 13; ++j)
          scene.roller.diameter[j] += 1e-6 * static_cast<double>(7 * j % 13) - 6e-6;
        const BearingModel model = make_bearing_model(scene);
        const double speed = kinematic_cage_speed(model, model.duty.speed);
        StaticEquilibrium equilibrium(model);
        for (int k = 0; k < 16; ++k) {
          const auto angle = roller_angles(model, 2 * std::numbers::pi * k / 104);
          const StaticState& rest =
              equilibrium.solve(angle.data(), speed, {0, -load}, RollerMotion::orbiting);
          EXPECT_TRUE(rest.converged) << clearance << " m, " << load << " N, position " << k;
          if (load > 0 && clearance > 0) {
            EXPECT_LT(rest.ring_z, 0.0);
          }
        }
      }
}

// Going round, ring and rollers are found in one iteration from where they were; from nowhere, the
// rollers settle for each place of the ring. Both are the same balance.
TEST(StaticEquilibrium, FollowsTheRollersAsTheyGoRound) {
  for (const double stiffness : {0.0, 50.0})
    for (const double load : {1000.0, 10000.0}) {
      Scene scene = dry_scene("nu205");
      if (stiffness > 0) {
        scene.model.ring_tilt = TiltModel::free;
        scene.bearing.tilt_stiffness = stiffness;
      }
      const BearingModel model = make_bearing_model(scene);
      const double speed = kinematic_cage_speed(model, model.duty.speed);
      const RingLoad on_ring{0, -load, 0.5 * stiffness, 0};
      StaticEquilibrium following(model);
      for (int k = 0; k < 40; ++k) {
        const auto angle = roller_angles(model, 2 * std::numbers::pi * k / 520);
        StaticEquilibrium anew(model);
        const StaticState& a =
            following.solve(angle.data(), speed, on_ring, RollerMotion::orbiting);
        const StaticState& b = anew.solve(angle.data(), speed, on_ring, RollerMotion::orbiting);
        EXPECT_TRUE(a.converged && b.converged);
        EXPECT_NEAR(a.ring_y, b.ring_y, 1e-13);
        EXPECT_NEAR(a.ring_z, b.ring_z, 1e-13);
        EXPECT_NEAR(a.tilt_y, b.tilt_y, 1e-11);
        EXPECT_NEAR(a.tilt_z, b.tilt_z, 1e-11);
        EXPECT_NEAR(a.ring_elastic[1], b.ring_elastic[1], 1e-5);
        for (std::size_t j = 0; j < model.groups.size() * kLanes; ++j)
          if (b.inner_force[j] > 1) {
            EXPECT_NEAR(a.radius[j], b.radius[j], 1e-13);
            EXPECT_NEAR(a.inner_force[j], b.inner_force[j], 1e-5);
          }
      }
    }
}

// At 20,000 rpm rollers approach and leave the inner race at some metres a second: a film squeezed
// by all of that, in the first guess, throws rollers off the races. Speed is let in by and by.
TEST(StaticEquilibrium, OfAFastLubricatedBearingIsFoundFromNothing) {
  for (const double load : {1000.0, 3000.0, 10000.0}) {
    const BearingModel model = make_bearing_model(aero_bearing(load));
    std::vector<double> angle(static_cast<std::size_t>(model.layout.padded()));
    for (std::size_t j = 0; j < angle.size(); ++j)
      angle[j] = 2 * std::numbers::pi * (static_cast<double>(j) + 0.3) / 28;
    StaticEquilibrium equilibrium(model);
    const StaticState& found =
        equilibrium.solve(angle.data(), 958, {0, -load}, RollerMotion::orbiting);
    EXPECT_TRUE(found.converged) << load << " N";
  }
}

}  // namespace
}  // namespace cagetol
