// Watches speak where a run is wrong, not where a window cannot tell: light and no load, preload,
// standstill, short windows.
#include <gtest/gtest.h>

#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

Scene watched_run(double settle = 4e-3, double measure = 6e-3) {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_time = settle;
  scene.window.measure_time = measure;
  return scene;
}

/// Like NU 224, made for 120 mm shafts: its ring weighs a hundred times that of the NU 205.
Scene large_bearing() {
  Scene scene = watched_run();
  auto& b = scene.bearing;
  b.roller_count = 17;
  b.bore_diameter = 120e-3;
  b.outside_diameter = 215e-3;
  b.width = 40e-3;
  b.inner_raceway_diameter = 143.5e-3;
  b.outer_raceway_diameter = 195.5e-3;
  b.shoulder_diameter = 188e-3;
  b.internal_clearance = 108e-6;
  scene.roller.diameter = {26e-3};
  scene.roller.length = 28e-3;
  scene.cage.inner_diameter = 145e-3;
  scene.cage.outer_diameter = 187e-3;
  scene.cage.width = 38e-3;
  scene.cage.pocket_width = {26.4e-3};
  scene.cage.pocket_length = {28.6e-3};
  scene.operation.radial_load = 0;
  scene.operation.inner_speed = 3400 * 0.10471975511965977;
  return scene;
}

void expect_ok(const Scene& scene) {
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.reason;
}
void expect_failed(const Scene& scene, const char* reason) {
  const Outcome outcome = simulate(scene);
  EXPECT_EQ(outcome.status, Status::failed);
  EXPECT_TRUE(outcome.reason.starts_with(reason)) << outcome.reason;
  EXPECT_NE(outcome.reason.find("remedy"), std::string::npos) << outcome.reason;
}

// Preloaded rollers rub on the ring with a thousandth of what presses them: statics is to be
// compared with that, not with the ring's weight.
TEST(Watches, PreloadWithoutLoad) {
  for (const double clearance : {-5e-6, -20e-6}) {
    Scene scene = watched_run();
    scene.operation.radial_load = 0;
    scene.bearing.internal_clearance = clearance;
    expect_ok(scene);
    EXPECT_LT(simulate(scene).run.static_consistency_error, 0.005);
  }
}

// What a loaded bearing at rest dissipates is less than its steps can resolve.
TEST(Watches, Standstill) {
  Scene scene = watched_run(6e-3, 6e-3);
  scene.operation.inner_speed = 0;
  expect_ok(scene);
  scene.integration.tolerance = 10;  // not resolved: wrong
  expect_failed(scene, "energy residual");
}

TEST(Watches, ShortWindows) {
  for (const double speed : {0.0, 600.0})
    for (const double measure : {1e-3, 1e-4, 1e-5, 1e-6}) {
      Scene scene = watched_run(4e-3, measure);
      scene.operation.inner_speed = speed;
      expect_ok(scene);
    }
}

TEST(Watches, LargeBearingsWithoutLoad) {
  Scene scene = large_bearing();
  scene.cage.guidance = "inner";
  scene.operation.gravity = 0;
  expect_ok(scene);
  scene.operation.gravity = 9.81;  // the cage hangs on the ring: statics does not know it
  expect_ok(scene);
}

// Steps too long for 3 kN, or for a ring without load.
TEST(Watches, StillFindStepsThatAreTooLong) {
  Scene scene = watched_run();
  scene.integration.method = "semi-implicit-euler";
  scene.operation.radial_load = 3000;
  expect_failed(scene, "energy residual");
}

// A mean force that is not the balance of what acts on the ring: the window begins while the load
// still falls on it.
TEST(Watches, StillFindAWindowThatHasNotSettled) {
  Scene scene = watched_run(0, 0.2e-3);
  scene.start.state = "centred";
  expect_failed(scene, "static consistency error");
}

}  // namespace
}  // namespace cagetol
