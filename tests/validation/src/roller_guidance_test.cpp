// Cages that rollers guide by lips or curved faces: they stay within the clearance of these.
#include <gtest/gtest.h>
#include <cstdlib>

#include "src/reading/scene_keys.hpp"
#include "src/scene/pocket_outline.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

constexpr double kPlay = 0.1e-3;  ///< of the cage between its rollers [m]

/// NU 208 with a machined brass cage, lips at bore and outside that leave 0.1 mm.
Scene nu208(bool oiled) {
  const toml::table table = parse_toml(R"(
name = "NU 208"
[bearing]
roller_count = 14
bore_diameter_mm = 40
outside_diameter_mm = 80
width_mm = 18
inner_raceway_diameter_mm = 49.5
outer_raceway_diameter_mm = 71.5
shoulder_diameter_mm = 67.4
internal_clearance_um = 37
flange_clearance_mm = 0.02
[roller]
diameter_mm = 11
length_mm = 12
profile = "logarithmic"
[cage]
material = "brass-cuzn40pb2"
inner_diameter_mm = 56
outer_diameter_mm = 65.8
width_mm = 17
pocket_width_mm = 11.2
pocket_length_mm = 12.25
[lubrication]
model = "none"
[load]
radial_N = 6000
[speed]
inner_rpm = 6000
)",
                                       "NU 208");
  Scene scene = read_scene(table, "NU 208");
  if (oiled) scene.lubrication.model = LubricationModel::film;
  scene.cage.guidance = Guidance::roller;
  const double pitch = pitch_radius(scene.bearing), roller = scene.roller.diameter[0] / 2;
  scene.cage.retention_inner = {retention_width(scene.cage, pitch, roller, 0, kPlay)};
  scene.cage.retention_outer = {retention_width(scene.cage, pitch, roller, 1, kPlay)};
  return scene;
}

/// The same with a moulded cage of polyamide, whose faces embrace the rollers.
Scene moulded(bool oiled) {
  Scene scene = nu208(oiled);
  scene.cage.material = {"pa66-gf25"};
  scene.cage.retention_inner = scene.cage.retention_outer = {kAuto};
  scene.cage.face_radius = 5.75e-3;
  return scene;
}

/// Runs `revolutions` of the cage and holds it to its guide.
void expect_guided(Scene scene, double revolutions) {
  check_scene(scene, "scene", nullptr);
  scene.window.measure_revolutions = revolutions;
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  // Rollers stand off the pitch circle by a quarter of the internal clearance, either way.
  EXPECT_LT(quantity(outcome, "whirl_radius_ratio_peak"),
            1.05 + scene.bearing.internal_clearance / 4 / kPlay);
  // Bars carry at least the cage's weight, and far less than the bearing's load.
  EXPECT_GT(quantity(outcome, "pocket_force_rms_N"), 0.1);
  EXPECT_LT(quantity(outcome, "pocket_force_peak_N"), 1000);
  EXPECT_EQ(quantity(outcome, "guide_force_peak_N"), 0);  // the rings are not reached
}

TEST(RollerGuidance, LipsHoldABrassCage) {
  expect_guided(nu208(false), 10);
}
TEST(RollerGuidance, CurvedFacesHoldAMouldedCage) {
  expect_guided(moulded(false), 10);
}
TEST(RollerGuidance, LipsHoldABrassCageInOil) {
  expect_guided(nu208(true), 2);
}

TEST(RollerGuidance, NightlySixtyRevolutionsOfEach) {
  if (std::getenv("CAGETOL_NIGHTLY") == nullptr) GTEST_SKIP() << "set CAGETOL_NIGHTLY=1 to run";
  for (const bool oiled : {false, true}) {
    expect_guided(nu208(oiled), 60);
    expect_guided(moulded(oiled), 60);
  }
}

}  // namespace
}  // namespace cagetol
