#include "src/lubrication/oil_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cagetol {
namespace {

TEST(OilLayer, FactorsFollowTheirFormulas) {
  for (const double x : {0.01, 0.3, 0.79, 0.81, 0.99}) {
    const auto f = oil_factors(x);
    const double z = std::min(1.0, (1 - x) / 0.2);
    const double more = std::pow(x, 1.5);
    EXPECT_NEAR(f.wedge, std::pow(1 - x, 2) * (1 - 0.3 * x), 1e-14);
    EXPECT_NEAR(f.squeeze, std::pow(1 - more, 1.5) * (1 - 0.1 * more), 1e-14);
    EXPECT_NEAR(f.rolling, std::pow(1 - std::sqrt(x), 2) * (1 - 0.8 * more), 1e-14);
    EXPECT_NEAR(f.couette, std::sqrt(1 - std::sqrt(x)) * z * z * (3 - 2 * z), 1e-14);
  }
}

TEST(OilLayer, NothingIsLeftBeyondTheLayer) {
  for (const double x : {1.0, 1.5, 1e6}) {
    const auto f = oil_factors(x);
    EXPECT_EQ(f.wedge, 0);
    EXPECT_EQ(f.squeeze, 0);
    EXPECT_EQ(f.rolling, 0);
    EXPECT_EQ(f.couette, 0);
  }
}

TEST(OilLayer, FactorsEndWithoutAKink) {
  using D = Dual<double, 1>;
  const auto f = oil_factors(variable<D>(1 - 1e-9, 0));
  for (const D& factor : {f.wedge, f.squeeze, f.rolling, f.couette}) {
    EXPECT_NEAR(factor.value, 0, 1e-8);
    EXPECT_NEAR(factor.slope[0], 0, 1e-4);
  }
}

TEST(OilLayer, DerivativesAgreeWithDifferences) {
  using D = Dual<double, 1>;
  for (const double x : {0.02, 0.5, 0.7999, 0.8001, 0.97}) {
    const auto f = oil_factors(variable<D>(x, 0));
    const double step = 1e-6;
    const auto up = oil_factors(x + step), down = oil_factors(x - step);
    const auto near = [&](double slope, double above, double below) {
      EXPECT_NEAR(slope, (above - below) / (2 * step), 1e-6 * std::max(1.0, std::abs(slope)));
    };
    near(f.wedge.slope[0], up.wedge, down.wedge);
    near(f.squeeze.slope[0], up.squeeze, down.squeeze);
    near(f.rolling.slope[0], up.rolling, down.rolling);
    near(f.couette.slope[0], up.couette, down.couette);
  }
}

/// Share that is left of the flooded film of an elastic line contact, whose inlet ends where the
/// gap is `ratio` times the film that is left; and the layer over the flooded film. Grubin: dQ/dx =
/// 12 eta u (h - h_c)/h^3 from the meniscus to the contact adds up to 1/alpha, h = h_c (1 + s^1.5)
/// close to the contact; x scales with h_c^(2/3), so h_c^(-4/3) times the integral is constant.
struct GrubinInlet {
  double layer, left;
  double rolling;  ///< share of the flooded inlet's rolling force, the integral of (h - h_c)/h^2
};
GrubinInlet grubin_inlet(double ratio) {
  const auto integral = [](double end, int power) {  // of s^1.5/(1 + s^1.5)^power, s = t^2, Simpson
    constexpr int n = 200000;
    const double step = std::sqrt(end) / n;
    double sum = 0;
    for (int i = 0; i <= n; ++i) {
      const double t = i * step;
      sum += (i == 0 || i == n ? 1
              : i % 2 == 1     ? 4
                               : 2) *
             2 * t * t * t * t / std::pow(1 + t * t * t, power);
    }
    return sum * step / 3;
  };
  const double end = std::pow(ratio - 1, 2.0 / 3);
  const double left = std::pow(integral(end, 3) / integral(1e4, 3), 0.75);
  // Beyond 1e6 the flooded inlet's integral of s^-1.5 is 2/sqrt(1e6).
  const double whole = integral(1e6, 2) + 2e-3;
  return {ratio * left, left, integral(end, 2) / whole * std::pow(left, -1.0 / 3)};
}

TEST(OilLayer, AnElasticFilmIsNoThickerThanItsMeniscusLetsItBe) {
  for (const double ratio : {1.001, 1.03, 1.2, 2.0, 4.0, 10.0, 50.0, 400.0}) {
    const GrubinInlet inlet = grubin_inlet(ratio);
    const double flooded = 1e-6;
    const auto film = layered(flooded, 0.0, -1e-5, inlet.layer * flooded);
    EXPECT_NEAR(film.thickness / (inlet.left * flooded), 1, 0.035) << ratio;
    EXPECT_LT(film.thickness, inlet.layer * flooded);
    EXPECT_EQ(film.load, 1);
    EXPECT_NEAR(oil_factors(1 / ratio).rolling, inlet.rolling, 0.08) << ratio;
  }
}

/// Reynolds' equation of a rigid cylinder, h = h_0 H, H = 1 + s^2, from the meniscus at s = -inlet:
/// dp/ds ~ (H - H_e)/H^3 until p and its slope vanish at s_e; integrals over s = tan(angle).
struct RigidInlet {
  double load, rolling, couette;
};
RigidInlet rigid_inlet(double inlet) {
  const double from = -std::atan(inlet);
  const auto integrals = [&](double exit, double& pressure) {
    constexpr int n = 20000;
    const double last = std::atan(exit), step = (last - from) / n, H_e = 1 + exit * exit;
    RigidInlet sums{0, 0, last - from};
    pressure = 0;
    for (int i = 0; i < n; ++i) {
      const double s = std::tan(from + (i + 0.5) * step), H = 1 + s * s;
      const double rise = (H - H_e) / (H * H) * step;
      sums.load += (pressure + 0.5 * rise) * H * step;
      sums.rolling += H * rise;
      pressure += rise;
    }
    return sums;
  };
  double low = 0, high = std::min(0.6, inlet), pressure = 0;
  for (int i = 0; i < 50; ++i) {  // pressure at the exit falls as it moves out
    const double middle = 0.5 * (low + high);
    integrals(middle, pressure);
    (pressure > 0 ? low : high) = middle;
  }
  return integrals(low, pressure);
}

TEST(OilLayer, FactorsAreThoseOfReynoldsEquation) {
  const RigidInlet flooded = rigid_inlet(1e6);
  for (const double x : {0.005, 0.02, 0.1, 0.2, 0.3, 0.45, 0.6, 0.75, 0.9}) {
    const double inlet = std::sqrt(1 / x - 1);
    const RigidInlet cut = rigid_inlet(inlet);
    const auto f = oil_factors(x);
    EXPECT_NEAR(f.wedge, cut.load / flooded.load, 0.011) << x;
    EXPECT_NEAR(f.rolling, cut.rolling / flooded.rolling, 0.011) << x;
    // Couette's factor is masked towards the layer's end.
    if (x < 0.8) {
      EXPECT_NEAR(f.couette, cut.couette / flooded.couette, 0.02) << x;
    }
    // Approach without rolling: p ~ 1/H^2 - x^2, none beyond either meniscus.
    const double angle = std::atan(inlet);
    double load = 0;
    for (int i = 0; i < 20000; ++i) {
      const double at = std::cos(angle * (i + 0.5) / 20000);
      load += (at * at - x * x / (at * at)) * angle / 20000;
    }
    EXPECT_NEAR(f.squeeze, load / (std::acos(-1.0) / 4), 0.01) << x;
  }
}

TEST(OilLayer, ARigidFilmKeepsItsThickness) {
  const auto film = layered(3e-6, 1.0, 2e-6, 20e-6);
  EXPECT_NEAR(film.thickness, 3e-6, 1e-12);
  EXPECT_NEAR(film.load, std::pow(1 - 3.0 / 20, 2) * (1 - 0.3 * 3 / 20), 1e-9);
}

TEST(OilLayer, NothingJumpsWhereTheGapReachesTheLayer) {
  using D = Dual<double, 1>;
  const double layer = 5e-6;
  const D gap = variable<D>(layer * (1 - 1e-7), 0);
  const auto film = layered(D{} + 6e-6, D{} + 0.2, gap, layer);
  for (const D& share : {film.load, film.of.wedge, film.of.squeeze, film.of.rolling}) {
    EXPECT_NEAR(share.value, 0, 1e-12);
    EXPECT_NEAR(share.slope[0] * layer, 0, 1e-5);
  }
}

TEST(OilLayer, SlopesOfALayeredFilmAgreeWithDifferences) {
  using D = Dual<double, 3>;
  const double layer = 5e-6, h = 2e-6, rigidity = 0.3;
  for (const double gap : {-3e-6, 1e-6, 3e-6, 4.5e-6}) {
    const auto film =
        layered(variable<D>(h, 0), variable<D>(rigidity, 1), variable<D>(gap, 2), layer);
    const double step[3] = {1e-12, 1e-6, 1e-12};
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](double side) {
        return layered(h + (k == 0 ? side * step[0] : 0), rigidity + (k == 1 ? side * step[1] : 0),
                       gap + (k == 2 ? side * step[2] : 0), layer);
      };
      const auto up = at(1), down = at(-1);
      const auto near = [&](double slope, double above, double below) {
        const double due = (above - below) / (2 * step[k]);
        EXPECT_NEAR(slope, due, 1e-5 * std::abs(due) + 1e-9 / step[k]) << gap << ", " << k;
      };
      near(film.load.slope[k], up.load, down.load);
      near(film.thickness.slope[k] / layer, up.thickness / layer, down.thickness / layer);
      near(film.of.squeeze.slope[k], up.of.squeeze, down.of.squeeze);
      near(film.of.rolling.slope[k], up.of.rolling, down.of.rolling);
    }
  }
}

}  // namespace
}  // namespace cagetol
