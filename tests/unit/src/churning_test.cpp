#include "src/lubrication/churning.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace cagetol {
namespace {

Churning of_cage() {
  Churning c;
  c.on = true;
  c.carried_along = 0.5;
  c.fluid = free_space_fluid(0.02, 850, 0.02);
  c.inner_radius = 18.5e-3;
  c.outer_radius = 21.7e-3;
  c.width = 14e-3;
  c.bore_gap = 2.75e-3;
  return c;
}

// Power in through the cage and the rings is what the fluid takes.
TEST(Churning, PowerInIsPowerOut) {
  Churning c = of_cage();
  for (const double outer_gap : {0.0, 0.5e-3}) {
    c.outer_gap = outer_gap;
    for (const double cage : {-200.0, 0.0, 254.0})
      for (const double inner : {-628.0, 0.0, 628.0})
        for (const double outer : {-300.0, 0.0, 500.0}) {
          const auto on = cage_churning(c, cage, inner, outer);
          EXPECT_NEAR(on.lost, -on.cage * cage - on.inner * inner - on.outer * outer,
                      1e-12 * (1 + on.lost));
          EXPECT_GE(on.lost, 0);
        }
  }
}

TEST(Churning, BoreDrivesWhatSidesBrake) {
  const auto still = cage_churning(of_cage(), 0.0, 628.0, 0.0);
  EXPECT_GT(still.cage, 0);
  EXPECT_LT(cage_churning(of_cage(), 628.0, 628.0, 0.0).cage, 0);
}

TEST(Churning, DerivativesAreThoseOfDifferences) {
  using D = Dual<double, 1>;
  const double w = 254, dw = 1e-3;
  Churning c = of_cage();
  c.outer_gap = 0.5e-3;
  const auto on = cage_churning(c, variable<D>(w, 0), 628.0, 100.0);
  const auto above = cage_churning(c, w + dw, 628.0, 100.0),
             below = cage_churning(c, w - dw, 628.0, 100.0);
  const auto slope = [&](double up, double down) { return (up - down) / (2 * dw); };
  EXPECT_NEAR(on.cage.slope[0], slope(above.cage, below.cage), 1e-6 * std::abs(on.cage.slope[0]));
  EXPECT_NEAR(on.inner.slope[0], slope(above.inner, below.inner),
              1e-6 * std::abs(on.inner.slope[0]));
  EXPECT_NEAR(on.outer.slope[0], slope(above.outer, below.outer),
              1e-6 * std::abs(on.outer.slope[0]));
  EXPECT_NEAR(on.lost.slope[0], slope(above.lost, below.lost), 1e-6 * std::abs(on.lost.slope[0]));
}

}  // namespace
}  // namespace cagetol
