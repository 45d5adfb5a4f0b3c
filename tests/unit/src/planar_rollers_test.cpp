// Planar rollers against spatial ones where nothing leads out of the plane, and what they leave
// out.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "src/integration/system.hpp"
#include "src/simulate.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene planar(Scene scene) {
  scene.model.rollers = RollerModel::planar;
  return scene;
}

struct Motion {
  Outcome outcome;
  std::vector<double> end;
  PackVector scale;
};

Motion motion_of(const Scene& scene) {
  Motion run;
  run.outcome = simulate(scene, {.on_state = [&](double, const double* y, const System& system) {
                           run.end.assign(y, y + system.size);
                           run.scale = system.scale;
                         }});
  return run;
}

/// The speed scene, loaded from the start so that rollers meet races and bars at once.
Scene brief_scene(long slices) {
  Scene scene = shipped_scene("speed-z16");
  scene.discretisation.race_slices = slices;
  scene.operation.load_ramp = 0;
  scene.start.state = StartState::equilibrium;
  scene.start.cage_offset_y = 0.1e-3;  // so that the cage drives some rollers
  scene.window.settle_time = 0;
  scene.window.measure_time = 2e-3;
  scene.watch.static_consistency_max = 1;  // too brief to settle
  return scene;
}

class PlanarRollers : public testing::TestWithParam<long> {};
INSTANTIATE_TEST_SUITE_P(Slices, PlanarRollers, testing::Values(1L, 3L));

// Both take the same steps; rounding of the slices' sums apart.
TEST_P(PlanarRollers, MoveLikeSpatialOnesWhereNothingLeadsOutOfThePlane) {
  const Scene scene = brief_scene(GetParam());
  const Motion spatial = motion_of(scene), flat = motion_of(planar(scene));
  ASSERT_EQ(spatial.outcome.status, Status::ok) << spatial.outcome.reason;
  ASSERT_EQ(flat.outcome.status, Status::ok) << flat.outcome.reason;
  ASSERT_EQ(spatial.end.size(), flat.end.size());
  double apart = 0;
  for (std::size_t i = 0; i < flat.end.size(); ++i)
    apart = std::max(apart, std::abs(flat.end[i] - spatial.end[i]) / flat.scale[i]);
  RecordProperty("apart", std::to_string(apart));
  EXPECT_LT(apart, 0.01);  // 10 nm, 0.1 mm/s
  EXPECT_GT(quantity(flat.outcome, "pocket_force_peak_N"), 0.1);
  for (const char* key : {"power_loss_W", "friction_torque_Nmm", "pocket_force_rms_N"})
    EXPECT_NEAR(quantity(flat.outcome, key) / quantity(spatial.outcome, key), 1, 1e-4) << key;
  EXPECT_NEAR(flat.outcome.run.energy_residual, spatial.outcome.run.energy_residual, 1e-5);
  EXPECT_LT(flat.outcome.run.energy_residual, 0.01);
}

TEST(PlanarRoller, StaysStraightWhateverWouldTiltIt) {
  Scene crooked = brief_scene(3);
  crooked.bearing.misalignment_y = 2e-3;
  crooked.roller.taper = {5e-6};
  crooked.cage.pocket_squareness = {3e-3};
  const Motion flat = motion_of(planar(crooked));
  const Motion straight = motion_of(planar(brief_scene(3)));
  EXPECT_EQ(flat.end, straight.end);
  EXPECT_NE(flat.end, motion_of(crooked).end);
  for (const char* key : {"roller_skew_rms_mrad", "roller_skew_p95_mrad", "roller_tilt_p95_mrad"})
    EXPECT_TRUE(std::isnan(quantity(flat.outcome, key))) << key;
  EXPECT_FALSE(std::isnan(quantity(flat.outcome, "cage_tilt_std_mrad")));
}

TEST(PlanarRoller, KeepsTheSlicesOfAProfiledRollerOnly) {
  Scene scene = planar(brief_scene(5));
  EXPECT_EQ(make_bearing_model(scene).race_slices.size(), 1u);
  scene.roller.profile = RollerProfile::logarithmic;
  EXPECT_EQ(make_bearing_model(scene).race_slices.size(), 5u);
}

}  // namespace
}  // namespace cagetol
