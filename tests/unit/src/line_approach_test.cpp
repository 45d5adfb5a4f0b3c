// Johnson's approach against the displacements of a disc and a half-plane under Hertz's pressure,
// summed up from Flamant's point loads; and what the races make of it.
#include "src/contact_laws/line_approach.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "src/contact_laws/hertz_line.hpp"
#include "src/input/input_error.hpp"
#include "src/model/bearing_model.hpp"
#include "src/model/race_stiffness.hpp"
#include "src/reading/scene_keys.hpp"
#include "src/scene/materials.hpp"
#include "tests/support/shipped_scene.hpp"

namespace cagetol {
namespace {

using std::numbers::pi;

const Material kBearingSteel{208e9, 0.30, 7810}, kCeramic{310e9, 0.26, 3200};

/// Displacement of a half-plane in plane strain along a unit line load, but for a constant, at the
/// depth z and the distance x beside the load [m2/N].
double flamant(const Material& m, double x, double z) {
  const double squared = x * x + z * z;
  return (1 + m.poisson) / (pi * m.young) * (z * z / squared - (1 - m.poisson) * std::log(squared));
}

/// Sum of what(x) over Hertz's pressure of the load 1, half width a: x = a sin(angle).
template <class F>
double over_pressure(double a, F what) {
  const int points = 20000;
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const double angle = pi * ((i + 0.5) / points - 0.5), part = std::cos(angle);
    sum += 2 / pi * part * part * what(a * std::sin(angle)) * (pi / points);
  }
  return sum;
}

/// Of the surface against the depth d, per unit load.
double half_plane(const Material& m, double a, double d) {
  return over_pressure(a, [&](double x) { return flamant(m, x, 0) - flamant(m, x, d); });
}

/// Of a disc's surface against its centre, pressed alike from above and below: both point loads at
/// the ends of a chord, and the even tension that frees the rim from what they do to it.
double disc(const Material& m, double a, double radius) {
  return over_pressure(a, [&](double x) {
    const double half = std::sqrt(radius * radius - x * x), tension = half / (pi * radius * radius);
    const double near = flamant(m, x, half - radius) - flamant(m, x, half);
    const double far = flamant(m, x, half + radius) - flamant(m, x, half);
    const double stretched = tension * radius * (1 + m.poisson) * (1 - 2 * m.poisson) / m.young;
    return near - far - stretched;
  });
}

LineContact contact_of(const Material& roller, const Material& ring) {
  return {roller, ring, 3.75e-3, 1 / 15.75e-3, 3.25e-3};
}

TEST(LineApproach, OfTheRollerIsThatOfADisc) {
  for (const double load : {3e3, 40e3, 300e3}) {
    const LineContact contact = contact_of(kBearingSteel, kCeramic);
    const double a = half_width(contact, load), narrow = a / contact.radius;
    EXPECT_NEAR(roller_approach(contact, load) / (load * disc(kBearingSteel, a, contact.radius)), 1,
                5e-5 + narrow * narrow)
        << load;
  }
}

TEST(LineApproach, OfTheRingIsThatOfAHalfPlane) {
  for (const double load : {3e3, 40e3, 300e3}) {
    const LineContact contact = contact_of(kBearingSteel, kCeramic);
    const double a = half_width(contact, load), narrow = a / contact.depth;
    EXPECT_NEAR(ring_approach(contact, load) / (load * half_plane(kCeramic, a, contact.depth)), 1,
                5e-5 + narrow * narrow)
        << load;
  }
}

TEST(LineApproach, RacesOfAScene) {
  Scene scene = shipped_scene("nu205");
  const auto [inner, outer] = race_lines(scene);
  EXPECT_NEAR(inner.radius, 3.75e-3, 1e-12);
  EXPECT_NEAR(inner.curvature, 1 / 15.7425e-3, 1e-9);  // 15.75 mm less a quarter of 30 um
  EXPECT_NEAR(outer.curvature, -1 / 23.2575e-3, 1e-9);
  EXPECT_NEAR(inner.depth, 3.25e-3, 1e-12);
  EXPECT_NEAR(outer.depth, 2.75e-3, 1e-12);
  EXPECT_NEAR(reference_line_load(scene), 5 * 1000 / (13 * 9e-3), 1e-6);
  scene.operation.radial_load = 0;
  EXPECT_EQ(reference_line_load(scene), kSmallestLineLoad);
}

TEST(LineApproach, PalmgrensIsThePairsModulus) {
  Scene scene = shipped_scene("nu205");
  scene.roller.material = {"silicon-nitride"};
  EXPECT_EQ(race_stiffness_modulus(scene),
            effective_modulus(roller_material(scene), ring_material(scene)));
}

/// Approach of the kernels' law over that of the relation, of both races and of each.
struct Misses {
  double both, inner, outer;
};
Misses misses(const Scene& scene, double load) {
  const double length = scene.roller.length;
  const auto [inner, outer] = race_lines(scene);
  const double d = elastic_penetration(make_bearing_model(scene).race,
                                       load * length / scene.discretisation.race_slices),
               in = roller_approach(inner, load) + ring_approach(inner, load),
               out = roller_approach(outer, load) + ring_approach(outer, load);
  return {2 * d / (in + out) - 1, d / in - 1, d / out - 1};
}

TEST(LineApproach, OfBothRacesIsMetAtTheLoadAndMissedByLittleAround) {
  Scene scene = shipped_scene("nu205");
  // Palmgren's law is softer: by 17 % at the inner and 24 % at the outer race.
  const double reference = reference_line_load(scene);
  EXPECT_NEAR(misses(scene, reference).inner, 0.173, 2e-3);
  EXPECT_NEAR(misses(scene, reference).outer, 0.239, 2e-3);
  scene.contact.race_approach = RaceApproach::line;
  // Found apart from the program (tests/validation/page/line_approach.py). Off the reference load
  // the power law misses by up to 5 % of both races, at either race by up to 9 %.
  struct Due {
    double radial, share;
    Misses misses;
  };
  for (const Due& due : {Due{300, 0.1, {0.0463, 0.0254, 0.0681}},
                         {300, 0.3, {0.0196, -0.0025, 0.0428}},
                         {300, 1, {0, -0.0240, 0.0252}},
                         {300, 3, {-0.0079, -0.0341, 0.0199}},
                         {1000, 0.1, {0.0257, 0.0033, 0.0492}},
                         {1000, 0.3, {0.0081, -0.0160, 0.0335}},
                         {1000, 1, {0, -0.0267, 0.0282}},
                         {1000, 3, {0.0050, -0.0251, 0.0369}},
                         {3000, 0.1, {0.0031, -0.0209, 0.0284}},
                         {3000, 1, {0, -0.0299, 0.0318}},
                         {3000, 3, {0.0201, -0.0145, 0.0571}},
                         {10000, 0.1, {-0.0273, -0.0533, 0.0002}},
                         {10000, 3, {0.0423, 0.0009, 0.0872}}}) {
    scene.operation.radial_load = due.radial;
    const Misses found = misses(scene, due.share * reference_line_load(scene));
    EXPECT_NEAR(found.both, due.misses.both, due.share == 1 ? 1e-12 : 1e-4) << due.radial;
    EXPECT_NEAR(found.inner, due.misses.inner, 1e-4) << due.radial << " N, " << due.share;
    EXPECT_NEAR(found.outer, due.misses.outer, 1e-4) << due.radial << " N, " << due.share;
  }
}

TEST(LineApproach, FilmsLieOnTheSameBodies) {
  Scene scene = shipped_scene("nu205");
  const BearingModel plain = make_bearing_model(scene);
  scene.contact.race_approach = RaceApproach::line;
  const BearingModel model = make_bearing_model(scene);
  EXPECT_GT(model.race.stiffness, 1.2 * plain.race.stiffness);
  const double at_1_N_m =
      elastic_penetration(model.race, scene.roller.length / scene.discretisation.race_slices);
  EXPECT_NEAR(model.inner_line.film.approach / at_1_N_m, 1, 1e-12);
  EXPECT_NEAR(model.outer_line.film.approach / at_1_N_m, 1, 1e-12);
  EXPECT_EQ(model.inner_line.film.modulus, plain.inner_line.film.modulus);
  EXPECT_EQ(model.bar.stiffness, plain.bar.stiffness);
}

TEST(LineApproach, EachBodyGivesWayByItsOwnMaterial) {
  const LineContact steel = contact_of(kBearingSteel, kBearingSteel),
                    hybrid = contact_of(kCeramic, kBearingSteel);
  const double load = 40e3, a = half_width(hybrid, load);
  EXPECT_LT(a, half_width(steel, load));
  EXPECT_NEAR(roller_approach(hybrid, load),
              load * (1 - 0.26 * 0.26) / (pi * 310e9) * (2 * std::log(15e-3 / a) - 1), 1e-15);
  EXPECT_NEAR(ring_approach(hybrid, load),
              load * 0.91 / (pi * 208e9) * (2 * std::log(6.5e-3 / a) - 0.3 / 0.7), 1e-15);
}

TEST(LineApproach, ThinRingsAreRefused) {
  Scene scene = shipped_scene("nu205");
  scene.bearing.bore_diameter = 31.2e-3;
  scene.bearing.inner_ring_mass = 0.05;
  EXPECT_NO_THROW(check_scene(scene, "scene.toml"));
  scene.contact.race_approach = RaceApproach::line;
  try {
    check_scene(scene, "scene.toml");
    FAIL();
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_THAT(what, testing::HasSubstr("contact.race.approach"));
    EXPECT_THAT(what, testing::HasSubstr("that on the inner ring has a half width of"));
    EXPECT_THAT(what, testing::HasSubstr("bearing.bore_diameter_mm = 31.2"));
  }
}

TEST(LineApproach, LoadsThatNoSteelBearsAreRefused) {
  Scene scene = shipped_scene("nu205");
  scene.operation.radial_load = 5e6;
  EXPECT_NO_THROW(race_stiffness_modulus(scene));
  scene.contact.race_approach = RaceApproach::line;
  EXPECT_THROW(race_stiffness_modulus(scene), std::domain_error);
  EXPECT_THROW(check_scene(scene, "scene.toml"), InputError);
}

}  // namespace
}  // namespace cagetol
