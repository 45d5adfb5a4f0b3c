// Frames of an animation against what is known of the run they show.
#include <gtest/gtest.h>

#include <cmath>

#include "mc/run/motion_frames.hpp"
#include "src/operation/operating_clearance.hpp"
#include "src/quantities/window_times.hpp"
#include "src/simulate.hpp"
#include "tests/support/reference_scene.hpp"

namespace cagetol {
namespace {

Scene short_scene() {
  Scene scene =
      read_scene(reference_scene_table(
                     "[window]\nsettle_revolutions = 0.3\nmeasure_revolutions = 1\n", "test"),
                 "test");
  scene.cage.model = CageKind::rigid;
  return OperatingScene(scene);
}

void run(const Scene& scene, MotionFrames& frames) {
  SimulateOptions options;
  options.on_state = [&](double t, const double* y, const System& system) {
    frames.record({t, y, system, nullptr});
  };
  ASSERT_EQ(simulate(scene, options).status, Status::ok);
}

TEST(MotionFrames, ShowRollersInTheirPocketsAndACageThatTurns) {
  const Scene scene = short_scene();
  MotionFrames frames(scene);
  EXPECT_TRUE(frames.json().is_null());
  run(scene, frames);
  const auto json = frames.json();
  const auto& geometry = json["geometry"];
  const std::size_t rollers = geometry["rollers"], count = json["time_ms"].size();
  ASSERT_EQ(rollers, 13u);
  EXPECT_NEAR(static_cast<double>(count), 1.3 * 180, 8);
  EXPECT_NEAR(geometry["pocket_clearance_um"][3].get<double>(), 150, 0.1);
  EXPECT_FALSE(json.contains("cage_stress_MPa"));
  double pressed = 0, held = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double y = json["cage_y_um"][k], z = json["cage_z_um"][k];
    EXPECT_LT(std::hypot(y, z), 1.1 * geometry["guide_clearance_um"].get<double>());
    for (std::size_t j = 0; j < rollers; ++j) {
      // The cage's centre moves pockets by up to its offset; half a clearance is left and right.
      EXPECT_LT(std::abs(json["place_um"][k * rollers + j].get<double>()),
                75 + std::hypot(y, z) + 5);
      pressed = std::max(pressed, json["leading_force_N"][k * rollers + j].get<double>());
      held = std::max(held, json["race_force_N"][k * rollers + j].get<double>());
    }
  }
  EXPECT_GT(pressed, 0.1);
  EXPECT_GT(held, 300);  // of 1000 N on 13 rollers, Stribeck's 4/Z and more
  const double turned = std::fmod(
      json["cage_angle_deg"].back().get<double>() - json["cage_angle_deg"][0].get<double>() + 720,
      360);
  const double revolutions = 1.3;
  EXPECT_NEAR(turned, std::fmod(360 * revolutions, 360), 12);
}

TEST(MotionFrames, ASecondRunBeginsAnew) {
  const Scene scene = short_scene();
  Scene lighter = scene;
  lighter.operation.radial_load /= 2;
  MotionFrames twice(scene), once(scene);
  run(scene, once);
  run(lighter, twice);
  run(scene, twice);
  EXPECT_EQ(once.json(), twice.json());
}

}  // namespace
}  // namespace cagetol
