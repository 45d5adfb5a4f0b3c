#include "src/lubrication/oil_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cagetol {
namespace {

TEST(OilLayer, FactorsFollowTheirFormulas) {
  for (const double x : {0.01, 0.3, 0.79, 0.81, 0.99}) {
    const auto f = oil_factors(x);
    const double z = std::min(1.0, (1 - x) / 0.2);
    EXPECT_NEAR(f.wedge, std::pow(1 - x, 2.3), 1e-14);
    EXPECT_NEAR(f.squeeze, std::pow(1 - std::pow(x, 1.5), 1.6), 1e-14);
    EXPECT_NEAR(f.rolling, std::pow(1 - std::sqrt(x), 2.1), 1e-14);
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

}  // namespace
}  // namespace cagetol
