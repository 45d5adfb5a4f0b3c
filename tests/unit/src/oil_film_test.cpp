// The oil film in series with the contact: published numbers, limits, identities.
#include "src/contact/oil_film.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/contact/hertz_line.hpp"

namespace cagetol {
namespace {

constexpr double kLength = 9e-3, kRoller = 3.75e-3;
const Material kSteel{206e9, 0.3, 7810};

FilmLaw film(double race_radius, OilFilm keys = {.model = "series"}) {
  return make_film_law(keys, effective_modulus(kSteel, kSteel), 1 / (1 / kRoller + 1 / race_radius),
                       kLength, 1);
}
NormalLaw contact() {
  return make_normal_law({.law = "hertz"}, kLength, 1);
}

// d_m 39 mm, alpha 1.8e-8 1/Pa, eta0 0.02 Pa s, 6000 rpm.
TEST(OilFilm, ThicknessOfTheReferenceBearing) {
  const double factor = film_speed_factor(5.8995);
  EXPECT_NEAR(oil_film(film(15.75e-3), 314.2, factor).thickness, 0.3777e-6, 2e-10);
  EXPECT_NEAR(oil_film(film(-23.25e-3), 314.2, factor).thickness, 0.4464e-6, 2e-10);
}

TEST(OilFilm, StiffnessIsTheLongFormula) {
  const double u = 5.8995, Q = 314.2, modulus = effective_modulus(kSteel, kSteel);
  const auto at = oil_film(film(15.75e-3), Q, film_speed_factor(u));
  const double R = 1 / (1 / kRoller + 1 / 15.75e-3);
  const double K_o = kLength * 13860.98647 * std::pow(0.02 * u, 5.3846) * std::pow(1.8e-8, 4.1538) *
                     std::pow(modulus, -0.2308) * std::pow(R, 3.3077) *
                     std::pow(at.thickness, -8.6923);
  EXPECT_NEAR(K_o * at.compliance, 1, 3e-3);  // its exponents are rounded to four decimals
  const double step = 1e-3;
  const double slope = (oil_film(film(15.75e-3), Q + step, film_speed_factor(u)).thickness -
                        oil_film(film(15.75e-3), Q - step, film_speed_factor(u)).thickness) /
                       (2 * step);
  EXPECT_NEAR(-slope / at.compliance, 1, 1e-6);
}

TEST(OilFilm, GoesOnSmoothlyToAFiniteFilmAtNoForce) {
  const FilmLaw law = film(15.75e-3);
  const double factor = film_speed_factor(5.0), least = law.least_force;
  const auto below = oil_film(law, least * (1 - 1e-9), factor),
             above = oil_film(law, least * (1 + 1e-9), factor);
  EXPECT_NEAR(below.thickness / above.thickness, 1, 1e-8);
  EXPECT_NEAR(below.compliance / above.compliance, 1, 1e-8);
  EXPECT_NEAR(thickest_film(law, factor) / above.thickness, 1.13, 1e-8);
}

TEST(OilFilm, VanishesWithTheSpeed) {
  const FilmLaw law = film(15.75e-3);
  EXPECT_EQ(oil_film(law, 300.0, film_speed_factor(0.0)).thickness, 0);
  EXPECT_LT(oil_film(law, 300.0, film_speed_factor(1e-9)).thickness, 1e-12);
  const auto dry = normal_force(contact(), 2e-6, 1e-3);
  const auto slow = film_contact(contact(), law, 2e-6, 1e-3, film_speed_factor(0.0));
  EXPECT_DOUBLE_EQ(slow.normal.force, dry.force);
  EXPECT_DOUBLE_EQ(slow.normal.stiffness, dry.stiffness);
}

TEST(OilFilm, StaysFiniteForPitch) {
  const FilmLaw law = film(15.75e-3, {.model = "series", .viscosity = 1e8});
  const double factor = film_speed_factor(50.0);
  for (double p : {-1.0, -1e-6, 0.0, 1e-6, 1e-4}) {
    const auto at = film_contact(contact(), law, p, 0.0, factor);
    EXPECT_TRUE(std::isfinite(at.normal.force) && std::isfinite(at.normal.stiffness)) << p;
    EXPECT_TRUE(std::isfinite(film_energy(contact(), law, at, factor)) && at.thickness > 0) << p;
  }
}

TEST(OilFilm, IsInSeriesWithTheContact) {
  const FilmLaw law = film(15.75e-3);
  const double factor = film_speed_factor(5.8995), thickest = thickest_film(law, factor);
  EXPECT_EQ(film_contact(contact(), law, -1.0001 * thickest, 0.0, factor).normal.force, 0);
  for (double p : {-0.9999 * thickest, -0.5 * thickest, 0.0, 1e-7, 1e-6, 5e-6, 3e-5}) {
    const auto at = film_contact(contact(), law, p, 0.0, factor);
    const auto elastic = normal_force(contact(), at.depth, 0.0);
    const auto oil = oil_film(law, elastic.elastic, factor);
    EXPECT_NEAR(at.depth - oil.thickness, p, 1e-10 * thickest) << p;
    EXPECT_NEAR(at.normal.elastic_stiffness * (1 / elastic.elastic_stiffness + oil.compliance), 1,
                1e-10)
        << p;
    EXPECT_GT(at.normal.force, 0) << p;
  }
}

TEST(OilFilm, ForceIsTheSlopeOfItsEnergy) {
  const FilmLaw law = film(15.75e-3);
  const double factor = film_speed_factor(5.8995), step = 1e-10;
  for (double p : {-2e-7, 1e-7, 2e-6, 2e-5}) {
    const auto energy = [&](double at) {
      return film_energy(contact(), law, film_contact(contact(), law, at, 0.0, factor), factor);
    };
    const double force = film_contact(contact(), law, p, 0.0, factor).normal.force;
    EXPECT_NEAR((energy(p + step) - energy(p - step)) / (2 * step) / force, 1, 1e-4) << p;
  }
}

TEST(OilFilm, LanesAgreeWithTheScalar) {
  const FilmLaw law = film(15.75e-3);
  for (double p : {-3e-7, 0.0, 1e-6, 2e-5}) {
    const double factor = film_speed_factor(5.0);
    const auto one = film_contact(contact(), law, p, 1e-2, factor);
    const auto all = film_contact(contact(), law, splat(p), splat(1e-2), splat(factor));
    EXPECT_NEAR(all.normal.force[3] / one.normal.force, 1, 1e-12) << p;
    EXPECT_NEAR(all.normal.stiffness[3] / one.normal.stiffness, 1, 1e-12) << p;
  }
}

}  // namespace
}  // namespace cagetol
