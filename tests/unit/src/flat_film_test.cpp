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
  const double gap = 5e-6, closing = 0.03, a = std::sqrt(kArea / std::numbers::pi);
  const double h = film_height(film(), gap);
  EXPECT_NEAR(h, gap,
              1.5e-3 * gap);  // roughness adds next to nothing to a film of ten times its height
  const FlatFilmForces<double> f = flat_film(film(1.0), gap, -closing);
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

/// Force of a narrow pad of width b whose gap is `gap(x)`, x from 0 where oil enters to 1: across
/// it p = 3 eta u h' (b^2/4 - y^2)/h^3, whatever its length.
template <class Gap>
double narrow_pad(double u, double b, Gap gap) {
  const int parts = 2000;
  double force = 0;
  for (int i = 0; i < parts; ++i) {
    const double low = gap(double(i) / parts), high = gap(double(i + 1) / parts),
                 h = (low + high) / 2;
    force += 3 * kEta * u * (low - high) / (h * h * h) * b * b * b / 6;
  }
  return force;
}

TEST(FlatFilm, WedgeIsThatOfANarrowPad) {
  const double gap = 2e-6, b = 1.5e-3, u = -6, h = film_height(film(), gap);
  const FlatFilm wide = with_wedge(film(1.0), kEta, b, 1);
  const auto plane = [&](double x) { return h * (2 - x); };
  const auto bent = [&](double x) { return h * (1 + (1 - x) * (1 - x)); };
  const double force = flat_wedge(wide, gap, u);
  EXPECT_GT(force, 10);
  EXPECT_NEAR(force, narrow_pad(-u, b, plane), 1e-3 * force);
  EXPECT_NEAR(force, narrow_pad(-u, b, bent), 1e-3 * force);
  // A plane pad shears eta A u times the mean of 1/h.
  EXPECT_NEAR(wide.shear, kEta * kArea * std::log(2.0), 1e-12);
  EXPECT_DOUBLE_EQ(2 * flat_wedge(with_wedge(film(1.0), kEta, b, 2), gap, u), force);
  EXPECT_EQ(flat_wedge(wide, gap, 0.0), 0);
  // It holds a steady film against a load; the squeeze adds, and a retreat takes all of it.
  EXPECT_NEAR(flat_film(wide, gap, 0.0, force).normal, force, 1e-4 * force);
  EXPECT_NEAR(flat_film(wide, gap, 1.0, force).normal, -1e-3, 1e-4);
}

TEST(FlatFilm, DerivativesOfTheWedgeAreThoseOfDifferences) {
  using D = Dual<double, 2>;
  const FlatFilm law = with_wedge(film(), kEta, 1.5e-3, 2);
  for (double gap = -20e-6; gap < 2 * kLayer; gap += 0.37e-6)
    for (const double u : {-6.0, -1e-3, 2e-4, 3.0}) {
      const D f = flat_wedge(law, variable<D>(gap, 0), variable<D>(u, 1));
      const double dg = 1e-11, du = 1e-7;
      const double by_gap =
                       (flat_wedge(law, gap + dg, u) - flat_wedge(law, gap - dg, u)) / (2 * dg),
                   by_speed =
                       (flat_wedge(law, gap, u + du) - flat_wedge(law, gap, u - du)) / (2 * du);
      EXPECT_NEAR(f.slope[0], by_gap, 1e-5 * std::abs(by_gap) + 1e-16 * f.value / dg + 10);
      EXPECT_NEAR(f.slope[1], by_speed, 1e-5 * std::abs(by_speed) + 1e-15 * f.value / du + 1e-6);
    }
}

TEST(FlatFilm, RefusesWhatIsNoFilm) {
  EXPECT_THROW(make_flat_film(0, kArea, kLayer, kLeast, 1, true), std::domain_error);
  EXPECT_THROW(make_flat_film(kEta, kArea, 0, kLeast, 1, true), std::domain_error);
}

}  // namespace
}  // namespace cagetol
