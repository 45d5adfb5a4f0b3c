// Film thickness, the steady law solved for the gap, squeeze: numbers from the formulas by an
// independent script, and the exact solution of Reynolds' equation for the combined film force.
#include "src/lubrication/line_film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/lubricated_contact.hpp"

namespace cagetol {
namespace {

constexpr double kTableShare = 1e-3;  ///< that tables are rounded to

template <class T>
SteadyFilm<T> film_at(const LineFilm& film, T gap, T speed) {
  return steady_film(film_scale(film, speed), gap);
}

TEST(LineFilm, ThicknessOfBothRegimes) {
  struct Row {
    double load, inner, rigid, outer;  // [N], [um]
  };
  const Row rows[] = {{4, 0.6658, 3.936, 0.7872},
                      {20, 0.5401, 0.7872, 0.6386},
                      {100, 0.4381, 0.1574, 0.5180},
                      {314.2, 0.3776, 0.0501, 0.4464},
                      {567, 0.3497, 0.0278, 0.4134}};
  const LubricatedContact inner, outer = LubricatedContact::outer();
  const LineFilm in = inner.film(), out = outer.film();
  for (const Row& row : rows) {
    const double q = row.load / inner.length, u = inner.speed;
    const auto elastic = [&](const LineFilm& film) {
      return 1e6 * film.elastic * std::pow(u, 0.7) * std::pow(q, -0.13);
    };
    EXPECT_NEAR(elastic(in), row.inner, kTableShare * row.inner);
    EXPECT_NEAR(elastic(out), row.outer, kTableShare * row.outer);
    // The table has four decimals: 0.0278 is rounded to 2e-3 of itself.
    EXPECT_NEAR(1e6 * in.rigid * u / q, row.rigid, std::max(kTableShare * row.rigid, 5.1e-5));
  }
}

// Races 69.5 and 85.5 mm, rollers 8 x 8 mm, Z = 20, no clearance, 837 rad/s, 0.01 Pa s, 20/GPa, 210
// GPa: a published check of Dowson-Higginson's film at the most loaded roller (4 F/Z).
TEST(LineFilm, PublishedFilmOfARoller) {
  LubricatedContact contact;
  contact.viscosity = 0.01;
  contact.pressure_viscosity = 20e-9;
  contact.modulus = 210e9 / (1 - 0.3 * 0.3);
  contact.length = 8e-3;
  contact.radius = 1 / (1 / 4e-3 + 1 / 34.75e-3);
  const LineFilm film = contact.film();
  const double expected[][2] = {{1600, 0.4247}, {800, 0.4647}, {400, 0.5085}};
  for (const auto& [load, thickness] : expected)
    EXPECT_NEAR(1e6 * film.elastic * std::pow(16.044, 0.7) * std::pow(load / 8e-3, -0.13),
                thickness, kTableShare * thickness);
}

TEST(LineFilm, LoadWhereTheRegimesMeet) {
  const LubricatedContact contact;
  const LineFilm film = contact.film();
  const double q = std::exp2((film.log_ratio + 0.3 * std::log2(contact.speed)) / 0.87);
  const double h = film.rigid * contact.speed / q;
  EXPECT_NEAR(q * contact.length, 30.8, 0.05);
  EXPECT_NEAR(1e6 * h, 0.511, 0.0005);
  EXPECT_NEAR(film.approach * std::pow(q, 0.9) / h, 0.293, 0.00055);
}

TEST(LineFilm, SolutionGivesTheLoadBack) {
  for (const double compliance : {0.0, 2e-10}) {
    const LubricatedContact contact;
    const LineFilm film = contact.film(compliance);
    double worst = 0;
    for (double u = 1e-3; u < 60; u *= 1.3)
      for (double load = 1e-4; load < 3e4; load *= 1.37) {
        const double speed = film_speed(u), q = load / contact.length;
        const double h = film_thickness(film, q, speed);
        const double gap = h - film.approach * std::pow(q, 0.9) - compliance * q;
        const auto state = film_at(film, gap, speed);
        worst = std::max({worst, std::abs(state.load / q - 1), std::abs(state.thickness / h - 1)});
      }
    EXPECT_LT(worst, compliance > 0 ? 1e-9 : 1e-10) << "compliance " << compliance;
  }
}

TEST(LineFilm, OpeningIsTheShareOfTheGapThatTheFilmTakes) {
  const LubricatedContact contact;
  const LineFilm film = contact.film();
  const double expected[][2] = {{4, 0.995}, {20, 0.884}, {100, 0.140}, {567, 0.024}};
  for (const auto& [load, opening] : expected) {
    const double q = load / contact.length, h = film_thickness(film, q, contact.speed);
    const auto state = film_at(film, h - film.approach * std::pow(q, 0.9), contact.speed);
    EXPECT_NEAR(state.opening, opening, 5e-4);
  }
}

TEST(LineFilm, LoadFallsWithTheGapAndIsNeverStifferThanTheContact) {
  const LubricatedContact contact;
  const LineFilm film = contact.film();
  using D = Dual<double, 1>;
  for (double u = 0.01; u < 51; u *= 1.5)
    for (double gap = -20e-6; gap < 40e-6; gap += 0.25e-6) {
      D speed{};
      speed.value = film_speed(u);
      const auto state = film_at(film, variable<D>(gap, 0), speed);
      const double stiffness = -state.load.slope[0];
      const double elastic = 1 / (0.9 * film.approach * std::pow(state.load.value, -0.1));
      EXPECT_GT(stiffness, 0);
      EXPECT_LE(stiffness, elastic * (1 + 1e-9)) << "u " << u << ", gap " << gap;
    }
}

TEST(LineFilm, DerivativesAgreeWithDifferences) {
  const LubricatedContact contact;
  using D = Dual<double, 2>;
  for (const double compliance : {0.0, 2e-10}) {
    const LineFilm film = contact.film(compliance);
    for (const double u : {0.0, 0.02, 2.0, -5.9, 50.0})
      for (const double gap : {-10e-6, -0.5e-6, 0.3e-6, 4e-6, 40e-6}) {
        const auto at = [&](double g, double v) { return film_at(film, g, film_speed(v)); };
        const auto state = film_at(film, variable<D>(gap, 0), film_speed(variable<D>(u, 1)));
        const double dg = 1e-11, du = 1e-6;
        const auto near = [&](double slope, double above, double below, double step, double size) {
          EXPECT_NEAR(slope, (above - below) / (2 * step),
                      1e-6 * std::abs(slope) + 1e-9 * size / step)
              << "u " << u << ", gap " << gap;
        };
        const auto gp = at(gap + dg, u), gm = at(gap - dg, u), up = at(gap, u + du),
                   um = at(gap, u - du);
        near(state.load.slope[0], gp.load, gm.load, dg, state.load.value);
        near(state.load.slope[1], up.load, um.load, du, state.load.value);
        near(state.thickness.slope[0], gp.thickness, gm.thickness, dg, state.thickness.value);
        near(state.opening.slope[0], gp.opening, gm.opening, dg, 1);
        near(state.opening.slope[1], up.opening, um.opening, du, 1);
        near(state.rigidity.slope[0], gp.rigidity, gm.rigidity, dg, 1);
        EXPECT_NEAR(state.opening.value, state.thickness.slope[0], 1e-9);
      }
  }
}

// A pack solves each of its lanes as one number would.
TEST(LineFilm, LanesAreAlike) {
  const LubricatedContact contact;
  const LineFilm film = contact.film();
  Pack gap, speed;
  for (int i = 0; i < kLanes; ++i) {
    gap[i] = (i - 3) * 1.3e-6;
    speed[i] = 0.02 + i;
  }
  const auto packed = film_at(film, gap, speed);
  for (int i = 0; i < kLanes; ++i) {
    const auto alone = film_at(film, splat(gap[i]), splat(speed[i]));
    EXPECT_EQ(packed.load[i], alone.load[0]);
    EXPECT_NEAR(packed.load[i] / film_at(film, gap[i], speed[i]).load, 1, 1e-12);
  }
}

TEST(LineFilm, SqueezeInAPocket) {
  LubricatedContact contact;
  contact.radius = 3.75e-3;
  const LineFilm film = contact.film();
  EXPECT_NEAR(squeeze_load(film, 5e-6, -0.05) * contact.length, 2.464, 2.464 * kTableShare);
  EXPECT_NEAR(squeeze_load(film, 1e-6, -0.05) * contact.length, 27.5, 0.05);
}

// Exact q/q_w of Reynolds' equation over kappa = (-dh/dt/u) sqrt(2 R/h), full film with cavitation.
TEST(LineFilm, FilmForceIsCloseToTheExactOne) {
  const LubricatedContact contact;
  const LineFilm film = contact.film();
  const double h = 2e-6, u = 3, q_w = film.rigid * u / h;
  const auto error = [&](double kappa, double exact) {
    const double rate = -kappa * u / std::sqrt(2 * film.radius / h);
    return film_load(q_w, squeeze_load(film, h, rate)) / q_w / exact - 1;
  };
  const double within_3[][2] = {{-0.5, 0.617}, {0.5, 1.565}, {1, 2.289}, {2, 4.004}, {5, 9.658}};
  for (const auto& [kappa, exact] : within_3)
    EXPECT_LT(std::abs(error(kappa, exact)), 0.03) << kappa;
  EXPECT_LT(std::abs(error(-1, 0.385)), 0.11);
}

}  // namespace
}  // namespace cagetol
