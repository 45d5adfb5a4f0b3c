#include "src/lubrication/flat_film.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

constexpr double kEta = 0.02, kArea = 2.4e-5, kLayer = 20e-6, kLeast = 0.5e-6;

FlatFilm film(double layer = kLayer) {
  return make_flat_film(kEta, kArea, layer, kLeast, 1, true);
}

// A disc of radius a on a plane: F = 3 pi eta a^4 (-dh/dt)/(2 h^3); between plates, shear stress
// eta du/h. A gap that is full of oil shows both.
TEST(FlatFilm, FullGapIsADiscAndCouettes) {
  const double h = 5e-6, closing = 0.03, a = std::sqrt(kArea / std::numbers::pi);
  const FlatFilmForces<double> f = flat_film(film(1.0), h, -closing);
  const double disc = 1.5 * std::numbers::pi * kEta * std::pow(a, 4) * closing / (h * h * h);
  EXPECT_NEAR(f.normal, disc, 2e-3);
  EXPECT_GT(disc, 0.5);
  EXPECT_NEAR(f.drag, kEta * kArea / h, 3e-3 * f.drag);
}

TEST(FlatFilm, PartsShareAWhole) {
  const FlatFilm half = make_flat_film(kEta, kArea, kLayer, kLeast, 2, true);
  EXPECT_DOUBLE_EQ(2 * half.squeeze, film().squeeze);
  EXPECT_DOUBLE_EQ(2 * half.shear, film().shear);
}

TEST(FlatFilm, HardlyPulls) {
  EXPECT_NEAR(flat_film(film(), 3e-6, 0.05).normal, -1e-3, 1e-4);
  EXPECT_EQ(flat_film(film(), 3e-6, 0.0).normal, 0);
}

TEST(FlatFilm, EndsWithTheLayer) {
  const FlatFilmForces<double> f = flat_film(film(), 1.01 * kLayer, -0.05);
  EXPECT_EQ(f.normal, 0);
  EXPECT_EQ(f.drag, 0);
}

TEST(FlatFilm, RoughnessBoundsIt) {
  const double deep = flat_film(film(), -100e-6, 0.0).drag;
  EXPECT_LT(deep, kEta * kArea / kLeast);
  EXPECT_GT(deep, 0.7 * kEta * kArea / kLeast);
}

TEST(FlatFilm, DerivativesAreThoseOfDifferences) {
  using D = Dual<double, 2>;
  for (double gap = -20e-6; gap < 2 * kLayer; gap += 0.37e-6)
    for (const double rate : {-0.05, -1e-3, 1e-3, 0.05}) {
      const FlatFilmForces<D> f = flat_film(film(), variable<D>(gap, 0), variable<D>(rate, 1));
      const double dg = 1e-11, dr = 1e-6;
      const auto at = [](double g, double r) { return flat_film(film(), g, r); };
      const double by_gap = (at(gap + dg, rate).normal - at(gap - dg, rate).normal) / (2 * dg),
                   by_rate = (at(gap, rate + dr).normal - at(gap, rate - dr).normal) / (2 * dr),
                   drag = (at(gap + dg, rate).drag - at(gap - dg, rate).drag) / (2 * dg);
      // A film that pulls is the difference of two numbers of the size of one that pushes.
      const double rounded = 4e-16 * (1e-3 + flat_film(film(), gap, -std::abs(rate)).normal),
                   rubs = 4e-16 * f.drag.value;
      EXPECT_NEAR(f.normal.slope[0], by_gap, 1e-6 * std::abs(by_gap) + 2 + rounded / dg)
          << gap << ' ' << rate;
      EXPECT_NEAR(f.normal.slope[1], by_rate, 1e-6 * std::abs(by_rate) + 1e-6 + rounded / dr)
          << gap;
      EXPECT_NEAR(f.drag.slope[0], drag, 1e-6 * std::abs(drag) + 1e-2 + rubs / dg) << gap;
    }
}

// C1: across the seams of roughness and layer, one-sided slopes agree.
TEST(FlatFilm, IsSmoothWhereItsBranchesMeet) {
  using D = Dual<double, 2>;
  for (const double seam : {2 * kLeast, kLayer}) {
    const double d = 1e-6 * seam;
    const auto at = [&](double gap) {
      return flat_film(film(), variable<D>(gap, 0), variable<D>(-0.05, 1));
    };
    const D below = at(seam - d).normal, above = at(seam + d).normal;
    const D drag_below = at(seam - d).drag, drag_above = at(seam + d).drag;
    const double steepest = std::abs(at(2 * kLeast).normal.slope[0]);
    EXPECT_NEAR(below.slope[0], above.slope[0], 1e-4 * steepest) << seam;
    EXPECT_NEAR(drag_below.slope[0], drag_above.slope[0],
                1e-4 * std::abs(at(2 * kLeast).drag.slope[0]))
        << seam;
  }
}

TEST(FlatFilm, RefusesWhatIsNoFilm) {
  EXPECT_THROW(make_flat_film(0, kArea, kLayer, kLeast, 1, true), std::domain_error);
  EXPECT_THROW(make_flat_film(kEta, kArea, 0, kLeast, 1, true), std::domain_error);
}

}  // namespace
}  // namespace cagetol
