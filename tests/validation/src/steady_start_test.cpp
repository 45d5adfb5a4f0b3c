// Long runs end where the steady start begins, from wherever they set out.
#include "src/statics/steady_start.hpp"

#include <gtest/gtest.h>
#include <cstdlib>
#include <numbers>

#include "src/integration/integrator.hpp"
#include "src/statics/start_state.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene oiled(double load) {
  Scene scene = shipped_scene("nu205");
  scene.lubrication.model = LubricationModel::film;
  scene.lubrication.viscosity = 0.02;
  scene.operation.radial_load = load;
  return scene;
}

/// Mean cage speed over turns `from` to `to` (of the cage without slip), over that speed; cage,
/// orbits and spins start from `share` of theirs at the equilibrium.
double cage_speed_ratio(const Scene& scene, double share, double from, double to) {
  const BearingModel model = make_bearing_model(scene);
  const StateLayout& l = model.layout;
  const std::vector<double> start = start_state(model, {.state = StartState::equilibrium});
  PackVector y(start.begin(), start.end());
  const auto slow = [&](int slot) { y[static_cast<std::size_t>(slot)] *= share; };
  for (int j = 0; j < l.padded(); ++j) {
    slow(l.velocity(kOrbitRate, j));
    slow(l.velocity(kSpin, j));
  }
  slow(l.border_velocity(kCagePhi));
  const double turning = kinematic_cage_speed(model, model.duty.speed),
               turn = 2 * std::numbers::pi / turning;
  System system(model);
  double t = 0;
  const auto integrator = make_integrator(scene.integration, system, t, y.data());
  const auto run_to = [&](double end) {
    while (t < end) {
      EXPECT_TRUE(system.linearise_at(t, y.data()));
      if (integrator->step(system, t, y.data(), end) != StepStatus::accepted) {
        ADD_FAILURE() << integrator->failure();
        break;
      }
    }
    return y[static_cast<std::size_t>(l.border_position(kCagePhi))];
  };
  const double before = run_to(from * turn), after = run_to(to * turn);
  return (after - before) / ((to - from) * turn * turning);
}

class NightlySteadyStart : public testing::TestWithParam<double> {};

TEST_P(NightlySteadyStart, IsWhereLongRunsEnd) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1";
  const Scene scene = oiled(GetParam());
  const BearingModel model = make_bearing_model(scene);
  const SteadyStart start = find_steady_start(model);
  ASSERT_TRUE(start.found);
  const double found = start.turn.cage_speed / kinematic_cage_speed(model, model.duty.speed);
  const double rolling = cage_speed_ratio(scene, 1, 50, 60),
               slipping = cage_speed_ratio(scene, 0.7, 50, 60);
  EXPECT_NEAR(found, rolling, 0.03 * rolling);
  EXPECT_NEAR(slipping, rolling, 0.05 * rolling);
  std::printf("%g N: start %.4f, long runs %.4f from rolling, %.4f from 30 %% slip\n", GetParam(),
              found, rolling, slipping);
}

INSTANTIATE_TEST_SUITE_P(Loads, NightlySteadyStart,
                         testing::Values(50.0, 100.0, 150.0, 300.0, 1000.0));

}  // namespace
}  // namespace cagetol
