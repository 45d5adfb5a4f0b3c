#include "src/lubrication/point_film.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

using std::numbers::pi;

constexpr double kModulus = 2.28e11, kRadius = 0.5;

PointFilm film(double layer = 10e-6, double roughness = 0.3e-6) {
  const Traction oil = make_traction(0.01, 2e-8, kRadius, kModulus, 5e6, 0.06, roughness);
  return make_point_film(hertz_point(kRadius, kRadius, kModulus), oil, 1.4e-3, layer, true);
}

// Of equal spheres or a sphere on a plane: delta = (9 F^2/(16 E*^2 R))^(1/3), a = (3 F R/(4
// E*))^(1/3) with E* = E'/2.
TEST(HertzPoint, IsExactForASphereOnAPlane) {
  const double force = 30, E = kModulus / 2;
  const HertzPoint h = hertz_point(kRadius, kRadius, kModulus);
  const double approach = std::cbrt(9 * force * force / (16 * E * E * kRadius)),
               a = std::cbrt(3 * force * kRadius / (4 * E));
  EXPECT_NEAR(h.stiffness * std::pow(approach, 1.5), force, 1e-12 * force);
  EXPECT_NEAR(h.area * std::pow(force, 2.0 / 3), pi * a * a, 1e-12 * a * a);
}

// Axes' ratio k by k^2 = (2 F - E (1 + G))/(E (1 - G)), G = R (1/R_x - 1/R_y), F and E the complete
// elliptic integrals of modulus sqrt(1 - 1/k^2).
TEST(HertzPoint, FollowsTheEllipticIntegrals) {
  for (const double ratio : {1.1, 1.3, 3.0, 20.0}) {
    const double other = ratio * kRadius, R = 1 / (1 / kRadius + 1 / other),
                 G = R * (1 / kRadius - 1 / other);
    double k = std::pow(ratio, 2 / pi), F = 0, E = 0;
    for (int i = 0; i < 2000; ++i) {
      const double modulus = std::sqrt(1 - 1 / (k * k));
      F = std::comp_ellint_1(modulus);
      E = std::comp_ellint_2(modulus);
      k += 0.2 * (std::sqrt((2 * F - E * (1 + G)) / (E * (1 - G))) - k);
    }
    const double stiffness = pi * k * kModulus * std::sqrt(2 * E * R / (9 * F * F * F)),
                 a = std::cbrt(6 * k * k * E * R / (pi * kModulus));
    const HertzPoint h = hertz_point(kRadius, other, kModulus);
    EXPECT_NEAR(std::pow(h.stiffness / stiffness, 2.0 / 3), 1, 0.03) << ratio;
    EXPECT_NEAR(h.area, pi * a * a / k, 0.03 * h.area) << ratio;
    EXPECT_EQ(h.stiffness, hertz_point(other, kRadius, kModulus).stiffness);
  }
  EXPECT_THROW(hertz_point(-1, 1, 1), std::domain_error);
}

// By hand: U = 3.509e-13, G = 4560, W = 3.509e-10, k = 1: H = 3.210e-6, h = 1.605 um.
TEST(PointFilm, IsThatOfHamrockAndDowson) {
  const double speed = 4, force = 20;
  const HertzPoint h = hertz_point(kRadius, kRadius, kModulus);
  const double due = 1.605e-6, approach = std::pow(force / h.stiffness, 2.0 / 3);
  const PointState<double> at = point_state(film(), speed, due - approach);
  EXPECT_NEAR(at.load, force, 5e-3 * force);
  EXPECT_NEAR(at.thickness, due, 1e-3 * due);
  EXPECT_NEAR(at.approach, approach, 5e-3 * approach);
}

// A reduced radius across the entrainment that is larger thickens the film by
// (1 - 0.61 e^(-0.73 k))/(1 - 0.61 e^(-0.73)).
TEST(PointFilm, ThickensWithTheEllipse) {
  const Traction oil = make_traction(0.01, 2e-8, kRadius, kModulus, 5e6, 0.06, 0.3e-6);
  const PointFilm wide =
      make_point_film(hertz_point(kRadius, 3 * kRadius, kModulus), oil, 1.4e-3, 10e-6, true);
  const double k = std::pow(3, 0.64);
  EXPECT_NEAR(std::exp2(wide.log_film - film().log_film),
              (1 - 0.61 * std::exp(-0.73 * k)) / (1 - 0.61 * std::exp(-0.73)), 1e-12);
}

TEST(PointFilm, SolvesItsGapAtEveryLoad) {
  for (double speed = 0.01; speed < 50; speed *= 3)
    for (double gap = -50e-6; gap < 30e-6; gap += 0.37e-6) {
      const PointFilm law = film();
      const PointState<double> at = point_state(law, speed, gap);
      const double h = std::exp2(law.log_film) * std::pow(speed, 0.67) *
                       std::pow(at.load, -kFilmFalls),
                   delta = std::exp2(law.log_approach) * std::pow(at.load, 2.0 / 3);
      const double rounded = 1e-12 * (h + delta);
      EXPECT_NEAR(at.thickness, h, rounded) << gap << ' ' << speed;
      EXPECT_NEAR(at.approach, delta, rounded);
      EXPECT_NEAR(at.thickness - at.approach, gap, rounded);
    }
}

TEST(PointFilm, DerivativesAreThoseOfDifferences) {
  using D = Dual<double, 2>;
  const PointFilm law = film();
  for (double gap = -10e-6; gap < 5e-6; gap += 0.131e-6)
    for (const double u : {0.02, 1.0, 8.0}) {
      const PointState<D> at = point_state(law, variable<D>(u, 0), variable<D>(gap, 1));
      const double du = 1e-6 * u, dg = 1e-11;
      const auto load = [&](double speed, double g) { return point_state(law, speed, g).load; };
      const double by_u = (load(u + du, gap) - load(u - du, gap)) / (2 * du),
                   by_g = (load(u, gap + dg) - load(u, gap - dg)) / (2 * dg);
      EXPECT_NEAR(at.load.slope[0], by_u, 1e-6 * std::abs(by_u) + 1e-9);
      EXPECT_NEAR(at.load.slope[1], by_g, 1e-6 * std::abs(by_g) + 1e-6) << gap << ' ' << u;
      const auto thickness = [&](double g) { return point_state(law, u, g).thickness; };
      EXPECT_NEAR(at.opening.value, (thickness(gap + dg) - thickness(gap - dg)) / (2 * dg), 1e-5);
      const auto drag = [&](double g) {
        const PointState<double> s = point_state(law, u, g);
        return point_friction(law, FrictionLaw{}, s.load, s.thickness, 9.0);
      };
      const PointFriction<D> rubs =
          point_friction(law, FrictionLaw{}, at.load, at.thickness, D{9.0, {}});
      const PointFriction<double> above = drag(gap + dg), below = drag(gap - dg);
      const double size = std::abs(above.drag) * 1e-16 / dg;
      EXPECT_NEAR(rubs.drag.slope[1], (above.drag - below.drag) / (2 * dg),
                  1e-5 * std::abs(rubs.drag.slope[1]) + 10 * size);
      EXPECT_NEAR(rubs.turning.slope[1], (above.turning - below.turning) / (2 * dg),
                  1e-5 * std::abs(rubs.turning.slope[1]) + 10 * above.turning * 1e-16 / dg + 1e-9);
    }
}

// A lane of a pack computes what a number alone does.
TEST(PointFilm, PacksAgreeWithNumbers) {
  Pack gap{};
  for (int i = 0; i < kLanes; ++i) gap[i] = -4e-6 + 1.3e-6 * i;
  const PointState<Pack> at = point_state(film(), splat(3.0), gap);
  for (int i = 0; i < kLanes; ++i) {
    const double load = point_state(film(), 3.0, double(gap[i])).load;
    EXPECT_NEAR(at.load[i], load, 1e-12 * load);
  }
}

// Shear of an oil film on a strip of the face, from where oil begins to a little past the middle:
// 0.641 of the integral of eta/(h + x^2/(2 R)) between both ends of the oil, and of that times x^2.
TEST(PointFilm, ShearsTheOilOnTheFace) {
  const double layer = 8e-6, h = 1.2e-6, face = 1.4e-3, eta = 0.01;
  const PointFriction<double> light =
      point_friction(film(layer, 1e-9), FrictionLaw{}, 1e-6, h, 4.0);
  double shear = 0, turning = 0;
  const double end = std::sqrt(2 * kRadius * (layer - h));
  const int parts = 20000;
  for (int i = 0; i < parts; ++i) {
    const double x = end * ((i + 0.5) / parts * 2 - 1), dx = 2 * end / parts,
                 one = 0.641 * eta * face * dx / (h + x * x / (2 * kRadius));
    shear += one;
    turning += one * x * x;
  }
  EXPECT_NEAR(light.drag, shear, 0.05 * shear);
  EXPECT_NEAR(light.turning, turning, 0.2 * turning);
}

// An ellipse that shears evenly resists spin by a b/2 of what it resists sliding.
TEST(PointFilm, TurnsAgainstItsEllipse) {
  PointFilm law = film(8e-6, 1e-9);
  law.inlet = 0;
  const double load = 30, E = kModulus / 2, a = std::cbrt(3 * load * kRadius / (4 * E));
  const PointFriction<double> rubs = point_friction(law, FrictionLaw{}, load, 1e-6, 4.0);
  EXPECT_GT(rubs.drag, 0);
  EXPECT_NEAR(rubs.turning, rubs.drag * a * a / 2, 1e-9 * rubs.turning);
}

// Of a rough film boundary friction takes over, and without film traction it is all there is.
TEST(PointFilm, MixesWithBoundaryFriction) {
  const double load = 40, v = 3;
  const double dry = friction(FrictionLaw{}, v * v).ratio * load;
  EXPECT_NEAR(point_friction(film(8e-6, 1e-3), FrictionLaw{}, load, 1e-6, v * v).drag, dry,
              1e-2 * dry);
  PointFilm plain = film();
  plain.shears = false;
  EXPECT_EQ(point_friction(plain, FrictionLaw{}, load, 1e-6, v * v).drag, dry);
  EXPECT_EQ(point_friction(plain, FrictionLaw{}, load, 1e-6, v * v).turning, 0);
}

TEST(PointFilm, StarvesAtTheLayer) {
  const double speed = 4;
  const PointState<double> light = point_state(film(), speed, 3e-6),
                           heavy = point_state(film(), speed, -20e-6);
  EXPECT_NEAR(starved_load(light, 0.5), 0.5 * light.load, 0.01 * light.load);
  EXPECT_GT(starved_load(heavy, 0.5), 0.9 * heavy.load);
  EXPECT_THROW(make_point_film(hertz_point(1, 1, 1e11), film().oil, 0, 1e-6, true),
               std::domain_error);
}

}  // namespace
}  // namespace cagetol
