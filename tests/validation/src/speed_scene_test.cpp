// The square speed scene against displacements of an independent program with the same laws, and
// the watch that must catch a step too long for explicit integration.
#include <gtest/gtest.h>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene one_slice(double load) {
  Scene scene = shipped_scene("speed-z16");
  scene.discretisation.race_slices = 1;
  scene.operation.radial_load = load;
  scene.window.settle_time = 3e-3;
  scene.window.measure_time = 1e-3;
  return scene;
}

struct Point {
  double load, displacement_um;
};

class SpeedScene : public testing::TestWithParam<Point> {};

TEST_P(SpeedScene, RingStandsWhereTheIndependentProgramPutsIt) {
  const Outcome outcome = simulate(one_slice(GetParam().load));
  EXPECT_NEAR(quantity(outcome, "ring_displacement_end_um") / GetParam().displacement_um, 1, 1e-3);
}

// At 10 kN the law's own damping carries a tenth of the load sideways: the quasi-static reference
// must know it.
TEST_P(SpeedScene, ElasticForceAndDisplacementAgreeWithStaticsOverTheSettledWindow) {
  Scene scene = one_slice(GetParam().load);
  scene.window.settle_time = 5e-3;
  scene.window.measure_time = 15e-3;
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
  EXPECT_LT(outcome.run.static_consistency_error, 0.005);
}

// Equilibria leave out inertia and friction: at an instant the ring may be elsewhere in its orbit
// of a third of a micrometre, its mean place is the same.
TEST_P(SpeedScene, EquilibriaPutTheRingWhereItsMotionKeepsIt) {
  Scene scene = one_slice(GetParam().load);
  scene.window.settle_time = 5e-3;
  scene.window.measure_time = 15e-3;
  const double moving = quantity(simulate(scene), "ring_displacement_mean_um");
  scene.model.motion = MotionModel::quasi_static;
  const double still = quantity(simulate(scene), "ring_displacement_mean_um");
  EXPECT_NEAR(still / moving, 1, 1e-3);
  scene.window.settle_time = 3e-3;
  scene.window.measure_time = 1e-3;
  const double end = quantity(simulate(scene), "ring_displacement_end_um");
  EXPECT_NEAR(end / GetParam().displacement_um, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Loads, SpeedScene,
                         testing::Values(Point{300, 13.705}, Point{1000, 18.515},
                                         Point{3000, 29.729}, Point{10000, 63.079}),
                         [](const auto& test) {
                           return std::to_string(static_cast<int>(test.param.load)) + "N";
                         });

}  // namespace
}  // namespace cagetol
