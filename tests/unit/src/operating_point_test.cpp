// The operating point against closed forms, and against a run in time.
#include "src/quantities/operating_point.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kRpm = pi / 30;

/// ISO/TS 16281 line stiffness, l = 10 mm, on races so large that contacts keep their direction.
Scene wide_bearing(long rollers, double clearance) {
  Scene scene;
  scene.bearing.roller_count = rollers;
  scene.bearing.inner_raceway_diameter = 1.991;
  scene.bearing.outer_raceway_diameter = 2.009;
  scene.bearing.shoulder_diameter = 2.006;
  scene.bearing.internal_clearance = clearance;
  scene.roller.diameter = {9e-3};
  scene.roller.length = 10e-3;
  scene.operation.gravity = scene.operation.inner_speed = 0;
  return scene;
}

/// The equations of ISO/TS 16281 by themselves: Q = c (d . n - s/2)^(10/9), c = 35,948 L^(8/9)
/// N/mm^(10/9), 1000 N along -z, over 640 positions of a pitch. Angle in which Q exceeds 10 N.
double iso_load_zone(int rollers, double half_clearance_mm) {
  const double c = 35948 * std::pow(10, 8.0 / 9);
  long loaded = 0;
  double y = 0, z = -half_clearance_mm - 0.002;
  for (int k = 0; k < 640; ++k) {
    std::vector<double> force(static_cast<std::size_t>(rollers));
    for (int iteration = 0; iteration < 100; ++iteration) {
      double f_y = 0, f_z = -1000, yy = 1, yz = 0, zz = 1;
      for (int j = 0; j < rollers; ++j) {
        const double angle = 2 * pi * (j + k / 640.0) / rollers, n = std::cos(angle),
                     m = std::sin(angle), depth = y * n + z * m - half_clearance_mm;
        double& on = force[static_cast<std::size_t>(j)] = 0;
        if (depth <= 0) continue;
        on = c * std::pow(depth, 10.0 / 9);
        const double slope = 10.0 / 9 * on / depth;
        f_y -= on * n, f_z -= on * m;
        yy += slope * n * n, yz += slope * n * m, zz += slope * m * m;
      }
      const double determinant = yy * zz - yz * yz;
      y += (f_y * zz - f_z * yz) / determinant;
      z += (f_z * yy - f_y * yz) / determinant;
    }
    for (const double on : force) loaded += on > 10;
  }
  return 2 * pi * static_cast<double>(loaded) / (640.0 * rollers);
}

TEST(LoadZone, IsThatOfIso16281) {
  const OperatingPoint tight = operating_point(wide_bearing(14, 0));
  EXPECT_NEAR(tight.roller_load, 291.86, 0.02);
  const OperatingPoint loose = operating_point(wide_bearing(14, 20e-6));
  EXPECT_NEAR(loose.roller_load, 492.8, 0.1);
  const double step = 2 * pi / (14 * 32);  // of the positions that are tried
  EXPECT_NEAR(tight.load_zone, iso_load_zone(14, 0), step);
  EXPECT_NEAR(loose.load_zone, iso_load_zone(14, 0.01), step);
  // Hertz on a nearly flat race: 1/R = 1/4.5 mm + 1/995.49 mm.
  const double radius = 1 / (1 / 4.5e-3 + 1 / 0.99549), modulus = 208e9 / (1 - 0.09);
  EXPECT_NEAR(loose.race_pressure / std::sqrt(49280 * modulus / (2 * pi * radius)), 1, 1e-3);
}

TEST(Film, IsThatOfTheHeaviestContact) {
  Scene scene = shipped_scene("nu205");
  scene.bearing.misalignment_z = 0;
  scene.discretisation.race_slices = 1;
  scene.roller.profile = RollerProfile::none;
  scene.lubrication.viscosity = 0.02;
  scene.lubrication.pressure_viscosity = 18e-9;
  const OperatingPoint at = operating_point(scene);
  // Races 15 um smaller and larger than the catalogue's: R_i 15.7425 mm, R_o 23.2575 mm.
  const double inner = 15.7425e-3, cage = 6000 * kRpm * inner / (inner + 23.2575e-3),
               u = (6000 * kRpm - cage) * inner, radius = 1 / (1 / 3.75e-3 + 1 / inner),
               q = at.roller_load / 9e-3, modulus = 208e9 / 0.91;
  const double elastic = 2.65 * std::pow(18e-9, 0.54) * std::pow(0.02 * u, 0.7) *
                         std::pow(radius, 0.43) * std::pow(modulus, -0.03) * std::pow(q, -0.13);
  const double rigid = 4.895 * 0.02 * u * radius / q;
  EXPECT_NEAR(at.entrainment, u, 1e-9);
  const double flooded = std::pow(std::pow(elastic, 4) + std::pow(rigid, 4), 0.25);
  const double share = std::pow(rigid / flooded, 4), filled = (1 - share) * flooded / 20e-6,
               thinned = 1 / (1 + filled * std::sqrt(filled / (filled + 0.045)));
  EXPECT_NEAR(at.film / (flooded * (share + (1 - share) * thinned)), 1, 1e-4);
  EXPECT_NEAR(at.lambda, at.film / 0.2e-6, 1e-9);
  scene.contact.race.roughness = 0.4e-6;
  EXPECT_NEAR(operating_point(scene).lambda, at.film / 0.4e-6, 1e-9);
  scene.lubrication.model = LubricationModel::none;
  EXPECT_TRUE(std::isnan(operating_point(scene).lambda));
}

TEST(Kinematics, AreThoseOfRolling) {
  Scene scene;
  scene.bearing.internal_clearance = 0;
  const OperatingPoint at = operating_point(scene);
  EXPECT_NEAR(at.cage_speed / kRpm, 2423.08, 0.005);
  EXPECT_NEAR(at.roller_speed / kRpm, 15023.1, 0.05);
  EXPECT_NEAR(at.roller_spin / kRpm, -12600.0, 0.05);
  EXPECT_NEAR(at.speed * at.pitch_diameter / kRpm, 234, 1e-9);
}

TEST(Ratings, AreThoseGivenOrThoseOfTheStandards) {
  Scene scene;
  EXPECT_NEAR(operating_point(scene).dynamic_rating, 32.2e3, 50);
  scene.bearing.dynamic_rating = 28.6e3;
  const OperatingPoint at = operating_point(scene);
  EXPECT_EQ(at.dynamic_rating, 28.6e3);
  EXPECT_NEAR(at.life, 1e6 * std::pow(28.6, 10.0 / 3), 1);
  EXPECT_NEAR(at.life_time / 3600, at.life / (60 * 6000), 1e-6);
}

TEST(Clearances, AreTheLeastOnes) {
  Scene scene;
  scene.roller.diameter.assign(13, 7.5e-3);
  scene.roller.diameter[4] = 7.502e-3;
  scene.cage.pocket_width.assign(13, 7.65e-3);
  scene.cage.pocket_width[4] = 7.64e-3;
  scene.cage.pocket_width[5] = 7.639e-3;
  const OperatingPoint at = operating_point(scene);
  EXPECT_NEAR(at.clearance.internal, 26e-6, 1e-12);
  EXPECT_NEAR(at.clearance.pocket_width, 138e-6, 1e-12);
  EXPECT_NEAR(at.clearance.pocket_length, 250e-6, 1e-12);
  EXPECT_NEAR(at.clearance.guide, 200e-6, 1e-12);
}

/// A run sees the load distribution that statics predict, and a thinnest film of the same contact.
TEST(OperatingPoint, IsNearTheRun) {
  Scene scene = shipped_scene("nu205");
  scene.window.settle_revolutions = 1;
  scene.window.measure_revolutions = 1;
  const Outcome outcome = simulate(scene);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.reason;
  const OperatingPoint at = operating_point(scene);
  EXPECT_NEAR(quantity(outcome, "roller_load_peak_N") / at.roller_load, 1, 0.03);
  EXPECT_NEAR(quantity(outcome, "race_pressure_peak_MPa") / (1e-6 * at.race_pressure), 1, 0.02);
  EXPECT_NEAR(quantity(outcome, "load_zone_mean_deg") * pi / 180, at.load_zone, 0.05);
  EXPECT_NEAR(quantity(outcome, "lambda_min_ratio") / at.lambda, 1, 0.03);
  EXPECT_NEAR(quantity(outcome, "lambda_min_ratio"), quantity(outcome, "film_min_um") / 0.2, 1e-9);
}

TEST(OperatingRows, HaveKeysOfTheirOwn) {
  std::set<std::string> keys;
  const OperatingPoint at = operating_point(shipped_scene("nu205"));
  for (const OperatingRow& row : operating_rows()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    const std::string key = row.key;  // it has neither fits nor a heat balance
    const bool unknown = key.ends_with("_fit_interference_um") || key.starts_with("balanced_");
    EXPECT_EQ(std::isfinite(row.value(at)), !unknown) << key;
    EXPECT_EQ(quantity_index(row.key), -1) << row.key;
  }
}

TEST(CageOrder, IsThatOfRollingLessTheSlip) {
  Scene scene = shipped_scene("nu205");
  scene.bearing.internal_clearance = 0;
  const OperatingPoint at = operating_point(scene);
  const double rolling = (1 - 7.5 / 39) / 2;
  EXPECT_NEAR(cage_order(at), rolling, 1e-12);
  EXPECT_NEAR(cage_order(with_slip(at, 0.1)), 0.9 * rolling, 1e-12);
  std::map<std::string, double> rows;
  for (const OperatingRow& row : operating_rows()) rows[row.key] = row.value(at);
  EXPECT_NEAR(rows["outer_passing_order"], 13 * rolling, 1e-11);
  EXPECT_NEAR(rows["inner_passing_order"], 13 * (1 + 7.5 / 39) / 2, 1e-11);
  // Only how fast one ring turns against the other counts, whichever turns; slip is of the cage as
  // it stands in the room.
  std::swap(scene.operation.inner_speed, scene.operation.outer_speed);
  const OperatingPoint turned = operating_point(scene);
  EXPECT_NEAR(cage_order(turned), rolling, 1e-12);
  EXPECT_NEAR(cage_order(with_slip(turned, 0.1)), 1 - 0.9 * (1 - rolling), 1e-12);
  scene.operation.inner_speed = scene.operation.outer_speed;
  EXPECT_FALSE(std::isfinite(cage_order(operating_point(scene))));
}

TEST(OperatingWarnings, NameLoadAndSpeedBeyondTheBearing) {
  Scene scene = shipped_scene("nu205");
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
  scene.operation.radial_load = 600e3;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("600 kN is above the static"),
                                                     HasSubstr("above the dynamic load rating")));
  scene.operation.radial_load = 15e3;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("above half the dynamic")));
  scene.operation.radial_load = 1000;
  scene.operation.inner_speed = 16100 * kRpm;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("limiting_speed_rpm = 16000")));
  scene.bearing.limiting_speed = kAuto;
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
  scene.operation.inner_speed = -300000 * kRpm;
  scene.bearing.reference_speed = kAuto;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("n d_m = 11700000 mm/min")));
}

TEST(OperatingWarnings, NameTheLeastLoadAndItsRule) {
  Scene scene = shipped_scene("nu205");
  scene.operation.radial_load = 173;
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
  scene.operation.radial_load = 170;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("by SKF's rule, 172 N")));
  scene.bearing.minimum_load_factor = kAuto;
  scene.operation.radial_load = 451;
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
  scene.operation.radial_load = 449;
  EXPECT_THAT(operating_warnings(scene), ElementsAre(HasSubstr("by Schaeffler's rule, 450 N")));
  scene.operation.inner_speed = 0;
  EXPECT_THAT(operating_warnings(scene), IsEmpty());
}

}  // namespace
}  // namespace cagetol
