// Growth of thick rings against hand values and limits.
#include "src/operation/thick_ring.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace cagetol {
namespace {

constexpr Material kSteel{200e9, 0.3, 8000};

// Inner radius 1, outer radius 2: strains of Lame's stresses s_t = p (1 + 4/r^2)/3, s_r = p (1 -
// 4/r^2)/3.
TEST(ThickRing, GrowsUnderPressureAsItsHoopStrainSays) {
  const ThickRing ring{10e-3, 20e-3, kSteel};
  const double p = 60e6;
  // At the bore s_t = 5 p/3, s_r = -p; outside s_t = 2 p/3, s_r = 0.
  EXPECT_NEAR(pressed_growth(ring, p, 0, 10e-3), 10e-3 * (100e6 + 0.3 * 60e6) / 200e9, 1e-15);
  EXPECT_NEAR(pressed_growth(ring, p, 0, 20e-3), 20e-3 * 40e6 / 200e9, 1e-15);
  // The same pressure on both surfaces: s_t = s_r = -p everywhere.
  for (const double r : {10e-3, 14e-3, 20e-3})
    EXPECT_NEAR(pressed_growth(ring, p, p, r), -r * p * 0.7 / 200e9, 1e-15);
}

TEST(ThickRing, IsSolidWithoutABoreAndABoreInALargeBodyWithoutEnd) {
  const ThickRing solid{0, 20e-3, kSteel};
  EXPECT_NEAR(pressed_growth(solid, 0, 60e6, 15e-3), -15e-3 * 60e6 * 0.7 / 200e9, 1e-15);
  const ThickRing large{10e-3, std::numeric_limits<double>::infinity(), kSteel};
  EXPECT_NEAR(pressed_growth(large, 60e6, 0, 10e-3), 10e-3 * 60e6 * 1.3 / 200e9, 1e-15);
  EXPECT_EQ(spinning_growth(large, 0, 10e-3), 0);
  EXPECT_THROW(spinning_growth(large, 1, 10e-3), std::domain_error);
}

// Thin: rho w^2 r^3/E. Solid, at its rim: rho w^2 b^3 (1 - nu)/(4 E).
TEST(ThickRing, GrowsByRotationWithinTheClosedLimits) {
  const double w = 1000, r = 50e-3, thin = 8000 * w * w * r * r * r / 200e9;
  EXPECT_NEAR(spinning_growth({0.999 * r, 1.001 * r, kSteel}, w, r) / thin, 1, 1e-5);
  EXPECT_NEAR(spinning_growth({0, r, kSteel}, w, r) / thin, 0.7 / 4, 1e-12);
  // Outside of a hollow one: rho w^2 b ((3 + nu) a^2 + (1 - nu) b^2)/(4 E).
  const double a = 30e-3;
  EXPECT_NEAR(spinning_growth({a, r, kSteel}, w, r),
              8000 * w * w * r * (3.3 * a * a + 0.7 * r * r) / 800e9, 1e-15);
  EXPECT_EQ(spinning_growth({a, r, kSteel}, -w, r), spinning_growth({a, r, kSteel}, w, r));
}

}  // namespace
}  // namespace cagetol
