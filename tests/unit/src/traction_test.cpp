// Sliding traction: numbers of the formulas by an independent script.
#include "src/lubrication/traction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/lubricated_contact.hpp"

namespace cagetol {
namespace {

Traction traction_law(const LubricatedContact& c, double roughness) {
  return make_traction(c.viscosity, c.pressure_viscosity, c.radius, c.modulus, 5e6, 0.06,
                       roughness);
}

TEST(Traction, CoefficientsOfTheFilm) {
  struct Row {
    double load, pressure, slow, middle, fast;  // [N], [MPa], at 0.01, 0.1 and 1 m/s
  };
  const Row rows[] = {{20, 128.3, 3.448e-5, 3.448e-4, 3.446e-3},
                      {100, 286.9, 2.814e-4, 2.800e-3, 2.081e-2},
                      {300, 497.0, 7.268e-3, 2.528e-2, 3.900e-2},
                      {567, 683.2, 2.431e-2, 3.519e-2, 4.261e-2}};
  const LubricatedContact c;
  const Traction law = traction_law(c, 1e-12);  // so smooth that the film carries all
  const FrictionLaw boundary;
  for (const Row& row : rows) {
    const double q = row.load / c.length;
    const double h = film_thickness(c.film(), q, film_speed(c.speed));
    EXPECT_NEAR(1e-6 * q / (law.width * std::sqrt(q)), row.pressure, 1e-3 * row.pressure);
    const auto mu = [&](double du) {
      return traction_ratio(law, boundary, q, h, du * du, 1.0) * du / q;
    };
    EXPECT_NEAR(mu(0.01), row.slow, 1e-3 * row.slow);
    EXPECT_NEAR(mu(0.1), row.middle, 1e-3 * row.middle);
    EXPECT_NEAR(mu(1), row.fast, 1e-3 * row.fast);
  }
}

TEST(Traction, RoughSurfacesRubAsDryOnes) {
  const LubricatedContact c;
  const Traction law = traction_law(c, 1e-3);  // the film is nothing against it
  const FrictionLaw boundary;
  for (const double du : {0.01, 0.5, 3.0})
    EXPECT_NEAR(traction_ratio(law, boundary, 1e4, 0.4e-6, du * du, 1.0),
                friction(boundary, du * du).ratio * 1e4,
                2e-3 * friction(boundary, du * du).ratio * 1e4);
}

// A roller that has left the outer race: 150 times the roughness and more.
TEST(Traction, ThickFilmsShearLikeOilInEveryLane) {
  const LubricatedContact c;
  const Traction law = traction_law(c, 0.2e-6);
  const FrictionLaw boundary;
  for (const double h : {10e-6, 30e-6, 100e-6, 1e-3}) {
    const double due = 2.849 * c.viscosity * std::sqrt(c.radius / h), q = 1e-3;
    const Pack packed = traction_ratio(law, boundary, splat(q), splat(h), splat(0.04), splat(1.0));
    EXPECT_NEAR(packed[0], due, 1e-3 * due) << h;
    EXPECT_NEAR(traction_ratio(law, boundary, q, h, 0.04, 1.0), packed[0], 1e-9 * due) << h;
  }
}

TEST(Traction, ShareOfTheAsperities) {
  const LubricatedContact c;
  const double h = 0.4e-6, q = 1e4, squared = 0.04;
  const FrictionLaw boundary;
  const double film = traction_ratio(traction_law(c, 1e-12), boundary, q, h, squared, 1.0);
  const double dry = friction(boundary, squared).ratio * q;
  const double share = std::exp(-1.8 * std::pow(2.0, 1.2));  // lambda = 2
  EXPECT_NEAR(traction_ratio(traction_law(c, 0.2e-6), boundary, q, h, squared, 1.0),
              (1 - share) * film + share * dry, 1e-9 * dry);
}

TEST(Traction, OfThickFilmsOverSmoothSurfacesIsTheirOwn) {
  // 150 times the roughness and more: of a pack, 2^x knows no x below -1000.
  const LubricatedContact c;
  const Traction smooth = traction_law(c, 1e-9), smoother = traction_law(c, 1e-10);
  for (const double h : {0.14e-6, 1e-6, 30e-6}) {
    const Pack one = splat(1), load = splat(1000), thick = splat(h), squared = splat(0.01);
    const Pack ratio = traction_ratio(smooth, FrictionLaw{}, load, thick, squared, one);
    EXPECT_EQ(ratio[0], traction_ratio(smoother, FrictionLaw{}, load, thick, squared, one)[0]) << h;
    const double alone = traction_ratio(smooth, FrictionLaw{}, 1000.0, h, 0.01, 1.0);
    EXPECT_NEAR(ratio[0], alone, 1e-12 * alone) << h;
  }
}

TEST(Traction, GrowsFromRestWithItsLargestSlope) {
  const LubricatedContact c;
  const Traction law = traction_law(c, 0.2e-6);
  const FrictionLaw boundary;
  const double q = 567 / c.length, h = film_thickness(c.film(), q, c.speed);
  const double slope = traction_ratio(law, boundary, q, h, 0.0, 1.0) * c.length;
  EXPECT_GT(slope, 3e3);  // [N s/m]: stiff
  EXPECT_LT(slope, 3e4);
  double last = 0;
  for (double du = 0.001; du < 3; du *= 1.1) {
    const double ratio = traction_ratio(law, boundary, q, h, du * du, 1.0) * c.length;
    EXPECT_LE(ratio, slope * (1 + 1e-9));
    EXPECT_GT(ratio * du, last);
    last = ratio * du;
  }
}

TEST(Traction, DerivativesAgreeWithDifferences) {
  const LubricatedContact c;
  const Traction law = traction_law(c, 0.2e-6);
  const FrictionLaw boundary;
  using D = Dual<double, 4>;
  for (const double q : {1.0, 2000.0, 1e5})
    for (const double h : {0.05e-6, 0.4e-6, 5e-6})
      for (const double squared : {1e-12, 1e-5, 0.02, 4.0}) {
        const double x[4] = {q, h, squared, 0.7};
        const D f = traction_ratio(law, boundary, variable<D>(q, 0), variable<D>(h, 1),
                                   variable<D>(squared, 2), variable<D>(0.7, 3));
        for (int i = 0; i < 4; ++i) {
          const double step = 1e-5 * x[i];
          const auto at = [&](double change) {
            double y[4] = {x[0], x[1], x[2], x[3]};
            y[i] += change;
            return traction_ratio(law, boundary, y[0], y[1], y[2], y[3]);
          };
          const double difference = (at(step) - at(-step)) / (2 * step);
          EXPECT_NEAR(f.slope[i], difference, 1e-6 * std::abs(f.slope[i]) + 1e-9 * f.value / x[i])
              << "q " << q << ", h " << h << ", squared " << squared << ", variable " << i;
        }
      }
}

}  // namespace
}  // namespace cagetol
