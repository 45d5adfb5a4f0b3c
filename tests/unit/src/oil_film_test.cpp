// The oil film in series with the contact: published numbers, limits, identities.
#include "src/contact_laws/oil_film.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "src/contact_laws/film_contact.hpp"
#include "src/contact_laws/hertz_line.hpp"

namespace cagetol {
namespace {

constexpr double kRollerLength = 9e-3, kRoller = 3.75e-3, kRollingSpeed = 5.8995;
const Material kRollerSteel{206e9, 0.3, 7810};

double radius(double race_radius) {
  return 1 / (1 / kRoller + 1 / race_radius);
}
NormalLaw contact(double exponent = 0) {
  if (exponent > 0)
    return make_normal_law({.law = ForceLaw::impact, .exponent = exponent}, kRollerLength, 1);
  return make_normal_law({.law = ForceLaw::hertz}, kRollerLength, 1);
}
FilmLaw film(double race_radius, OilFilm keys = {.model = FilmModel::series},
             const NormalLaw& normal = contact()) {
  return make_film_law(keys, effective_modulus(kRollerSteel, kRollerSteel), radius(race_radius),
                       kRollerLength, 1, normal);
}
const OilFilm kSeries{.model = FilmModel::series};

// d_m 39 mm, alpha 1.8e-8 1/Pa, eta0 0.02 Pa s, 6000 rpm.
TEST(OilFilm, ThicknessOfTheReferenceBearing) {
  const FilmLaw inner = film(15.75e-3, kSeries), outer = film(-23.25e-3, kSeries);
  EXPECT_NEAR(film_thickness(inner, film_at_speed(inner, kRollingSpeed), 314.2), 0.3777e-6, 2e-10);
  EXPECT_NEAR(film_thickness(outer, film_at_speed(outer, kRollingSpeed), 314.2), 0.4464e-6, 2e-10);
}

TEST(OilFilm, StiffnessIsTheLongFormula) {
  const double Q = 314.2, modulus = effective_modulus(kRollerSteel, kRollerSteel);
  const FilmLaw law = film(15.75e-3);
  const auto at = film_at_speed(law, kRollingSpeed);
  const double h = film_thickness(law, at, Q), k = film_slopes(law, at, Q, h).compliance;
  const double K_o = kRollerLength * 13860.98647 * std::pow(0.02 * kRollingSpeed, 5.3846) *
                     std::pow(1.8e-8, 4.1538) * std::pow(modulus, -0.2308) *
                     std::pow(radius(15.75e-3), 3.3077) * std::pow(h, -8.6923);
  EXPECT_NEAR(K_o * k, 1, 3e-3);  // its exponents are rounded to four decimals
}

/// Over every part of the film, among them both sides of where they meet.
template <class Check>
void at_many_forces(const FilmLaw& law, double u, Check check) {
  const auto at = film_at_speed(law, u);
  for (double Q = 1e-3; Q < 1e4; Q *= 1.3) check(at, Q);
  for (const double side : {1 - 1e-3, 1 + 1e-3}) check(at, law.minimum_force * side);
}

TEST(OilFilm, SlopesAreThoseOfTheThickness) {
  for (const double u : {0.004, 0.3, 5.9}) {
    const FilmLaw law = film(15.75e-3, kSeries);
    at_many_forces(law, u, [&](const FilmAtSpeed<double>& at, double Q) {
      const double h = film_thickness(law, at, Q), step = 1e-5;
      const auto s = film_slopes(law, at, Q, h);
      const auto compliance = [&](const FilmAtSpeed<double>& speed, double force) {
        return film_slopes(law, speed, force, film_thickness(law, speed, force)).compliance;
      };
      const double up = Q * (1 + step), down = Q * (1 - step);
      const double slope =
          (film_thickness(law, at, up) - film_thickness(law, at, down)) / (up - down);
      EXPECT_NEAR(-slope / s.compliance, 1, 1e-6) << Q;
      EXPECT_NEAR((compliance(at, up) - compliance(at, down)) / (up - down), s.bend,
                  1e-5 * s.compliance / Q)
          << Q;
      const auto fast = film_at_speed(law, u * (1 + step)),
                 slow = film_at_speed(law, u * (1 - step));
      const double wide = 2 * step * u;
      EXPECT_NEAR((film_thickness(law, fast, Q) - film_thickness(law, slow, Q)) / wide / s.by_speed,
                  1, 1e-5)
          << Q;
      EXPECT_NEAR((compliance(fast, Q) - compliance(slow, Q)) / wide, s.compliance_by_speed,
                  1e-5 * s.compliance / u)
          << Q;
    });
  }
}

TEST(OilFilm, PartsMeetWithTheirSlopes) {
  const FilmLaw law = film(15.75e-3, kSeries);
  const auto at = film_at_speed(law, kRollingSpeed);
  const double Q = law.minimum_force;
  const double below = film_thickness(law, at, Q * (1 - 1e-9)),
               above = film_thickness(law, at, Q * (1 + 1e-9));
  EXPECT_NEAR(below / above, 1, 1e-8);
  EXPECT_NEAR(film_slopes(law, at, Q * (1 - 1e-9), below).compliance /
                  film_slopes(law, at, Q * (1 + 1e-9), above).compliance,
              1, 1e-7);
  EXPECT_NEAR(thickest_film(law, at) / film_thickness(law, at, Q), 1.13, 1e-8);
  const auto slow = film_at_speed(law, kSlowEntrainment * (1 - 1e-9)),
             fast = film_at_speed(law, kSlowEntrainment * (1 + 1e-9));
  EXPECT_NEAR(film_thickness(law, slow, 50.0) / film_thickness(law, fast, 50.0), 1, 1e-8);
  EXPECT_NEAR(slow.elastic_growth / fast.elastic_growth, 1, 1e-7);
}

TEST(OilFilm, VanishesWithTheSpeed) {
  const FilmLaw law = film(15.75e-3, kSeries);
  EXPECT_EQ(film_thickness(law, film_at_speed(law, 0.0), 300.0), 0);
  EXPECT_LT(film_thickness(law, film_at_speed(law, 1e-9), 300.0), 1e-12);
  const auto dry = normal_force(contact(), 2e-6, 1e-3);
  const auto slow = film_contact(contact(), law, film_at_speed(law, 0.0), 2e-6, 1e-3);
  EXPECT_NEAR(slow.normal.force / dry.force, 1, 1e-12);
  EXPECT_NEAR(slow.normal.stiffness / dry.stiffness, 1, 1e-12);
  EXPECT_LT(slow.by_speed, 1e-3);
  EXPECT_EQ(film_contact(contact(), law, film_at_speed(law, 0.0), -1e-9, 1e-3).normal.force, 0);
}

TEST(OilFilm, StaysFiniteForPitch) {
  OilFilm keys = kSeries;
  keys.viscosity = 1e8;
  const FilmLaw law = film(15.75e-3, keys);
  for (const double u : {0.0, 1e-9, 1e-3, 50.0}) {
    const auto speed = film_at_speed(law, u);
    for (double p : {-1.0, -1e-6, 0.0, 1e-6, 1e-4}) {
      const auto at = film_contact(contact(), law, speed, p, 0.0);
      EXPECT_TRUE(std::isfinite(at.normal.force) && std::isfinite(at.normal.stiffness)) << p;
      EXPECT_TRUE(std::isfinite(at.by_speed)) << p;
      EXPECT_TRUE(std::isfinite(film_energy(contact(), law, speed, at))) << p;
    }
  }
}

// Every part of the film, thin and thick oil, several exponents: nothing but the equations
// p = delta - h and 1/K = 1/K_r + k.
TEST(OilFilm, IsInSeriesWithTheContact) {
  OilFilm keys = kSeries;
  for (const double viscosity : {1e-4, 0.02, 1.0, 100.0})
    for (const double exponent : {0.0, 1.0, 1.5, 3.0})
      for (const double u : {0.003, 0.5, 5.8995, 80.0}) {
        keys.viscosity = viscosity;
        const NormalLaw normal = contact(exponent);
        const FilmLaw law = film(15.75e-3, keys, normal);
        const auto speed = film_at_speed(law, u);
        const double thickest = thickest_film(law, speed);
        EXPECT_EQ(film_contact(normal, law, speed, -1.0001 * thickest, 0.0).normal.force, 0);
        for (double force = 1e-3; force < 1e5; force *= 1.7) {
          const double delta = elastic_penetration(normal, force),
                       h = film_thickness(law, speed, force), p = delta - h;
          const auto at = film_contact(normal, law, speed, p, 0.0);
          const auto elastic = normal_force(normal, at.depth, 0.0);
          const double k = film_slopes(law, speed, elastic.elastic, at.thickness).compliance;
          // What p can tell of delta: its own rounding.
          const double told = 1e-10 + 1e-14 * h / delta;
          EXPECT_NEAR(at.depth / delta, 1, told) << force << " N, " << viscosity << " Pa s";
          EXPECT_NEAR(at.normal.elastic_stiffness * (1 / elastic.elastic_stiffness + k), 1, 1e-10)
              << force;
        }
      }
}

TEST(OilFilm, SlopesOfTheForceAreThoseOfDifferences) {
  for (const double exponent : {0.0, 1.5}) {
    const NormalLaw normal = contact(exponent);
    const FilmLaw law = film(15.75e-3, kSeries, normal);
    for (const double u : {0.004, 0.5, 5.9})
      for (const double force : {0.2, 3.0, 20.0, 34.0, 300.0}) {
        const auto speed = film_at_speed(law, u);
        const double p = elastic_penetration(normal, force) - film_thickness(law, speed, force);
        const double rate = 0.02, step = 1e-6 * thickest_film(law, speed), faster = 1e-5 * u;
        const auto at = film_contact(normal, law, speed, p, rate);
        const auto force_at = [&](double depth, double speed_of) {
          return film_contact(normal, law, film_at_speed(law, speed_of), depth, rate).normal;
        };
        const auto up = force_at(p + step, u), down = force_at(p - step, u);
        const double scale = at.normal.force + at.normal.stiffness * 1e-9;
        EXPECT_NEAR((up.force - down.force) / (2 * step), at.normal.stiffness,
                    1e-5 * at.normal.stiffness + 1e-12 * scale / step)
            << force << " N, " << u << " m/s";
        const auto fast = force_at(p, u + faster), slow = force_at(p, u - faster);
        EXPECT_NEAR((fast.force - slow.force) / (2 * faster), at.by_speed,
                    1e-4 * at.by_speed + 1e-12 * scale / faster)
            << force << " N, " << u << " m/s";
        EXPECT_NEAR((fast.elastic - slow.elastic) / (2 * faster), at.elastic_by_speed,
                    1e-4 * at.elastic_by_speed + 1e-12 * scale / faster);
        const auto moving = film_contact(normal, law, speed, p, rate * 1.001);
        EXPECT_NEAR((moving.normal.force - at.normal.force) / (0.001 * rate), at.normal.damping,
                    1e-6 * at.normal.damping);
      }
  }
}

TEST(OilFilm, ForceIsTheSlopeOfItsEnergy) {
  const FilmLaw law = film(15.75e-3, kSeries);
  const auto speed = film_at_speed(law, kRollingSpeed);
  const double thickest = thickest_film(law, speed);
  const auto energy = [&](double at) {
    return film_energy(contact(), law, speed, film_contact(contact(), law, speed, at, 0.0));
  };
  EXPECT_NEAR(energy(-thickest * (1 - 1e-9)), 0, 1e-15);
  for (const double p :
       {-0.9 * thickest, -0.4 * thickest, -2e-6, -2e-7, -2e-8, 1e-8, 1e-7, 2e-6, 2e-5}) {
    const double step = 1e-10;
    const double force = film_contact(contact(), law, speed, p, 0.0).normal.force;
    if (force == 0) continue;
    EXPECT_NEAR((energy(p + step) - energy(p - step)) / (2 * step) / force, 1, 1e-4) << p;
  }
}

TEST(OilFilm, LanesAgreeWithTheScalar) {
  const FilmLaw law = film(15.75e-3, kSeries);
  // Every part of the film side by side.
  const double places[] = {-20e-6, -5e-6, -3e-7, -5e-8, 0, 1e-7, 1e-6, 2e-5},
               speeds[] = {5, 5, 5, 5.1, 5, 4.9, 0.1, 0.001};
  for (int place = 0; place < 8; ++place) {
    const int first = place / kLanes * kLanes, lane = place % kLanes;
    const auto all = film_contact(contact(), law, film_at_speed(law, load(speeds + first)),
                                  load(places + first), splat(1e-2));
    const auto one =
        film_contact(contact(), law, film_at_speed(law, speeds[place]), places[place], 1e-2);
    if (one.normal.force == 0) {
      EXPECT_EQ(all.normal.force[lane], 0) << lane;
      continue;
    }
    EXPECT_NEAR(all.normal.force[lane] / one.normal.force, 1, 1e-11) << lane;
    EXPECT_NEAR(all.normal.stiffness[lane] / one.normal.stiffness, 1, 1e-11) << lane;
    EXPECT_NEAR(all.by_speed[lane] / one.by_speed, 1, 1e-11) << lane;
  }
}

}  // namespace
}  // namespace cagetol
