#include "src/contact_laws/hertz_line.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

const Material kSteel{206e9, 0.30, 7850};

TEST(HertzLine, ModulusOfSteelOnSteel) {
  EXPECT_NEAR(effective_modulus(kSteel, kSteel), 226.3736e9, 1e5);  // 206/(1 - 0.09)
  EXPECT_DOUBLE_EQ(effective_modulus(kSteel, {1e30, 0, 1}), 2 * 206e9 / 0.91);
}

TEST(HertzLine, HandComputedPoint) {
  // Q 1000 N, R 5 mm, l 10 mm, E' 226.3736 GPa: b^2 = 40/(pi 2.263736e9) = 5.624505e-9 m^2.
  const HertzLine c = hertz_line(1000, 5e-3, 10e-3, 226.3736e9);
  EXPECT_NEAR(c.half_width, 74.9967e-6, 1e-10);
  EXPECT_NEAR(c.peak_pressure, 848.864e6, 1e4);
}

TEST(HertzLine, PressureIsAHalfEllipseThatCarriesTheForce) {
  const double length = 9e-3, force = 314.2;
  const HertzLine c = hertz_line(force, 3e-3, length, 226e9);
  EXPECT_NEAR(std::numbers::pi / 2 * c.half_width * c.peak_pressure * length, force, 1e-10);
}

TEST(HertzLine, AgreesWithHarrisShorthand) {
  // Harris: b = 3.35e-3 sqrt(Q/(l sum rho)) mm, lengths in mm, E 206 GPa.
  for (double force : {10.0, 314.2, 5000.0})
    for (double sign : {1.0, -1.0}) {
      const double R1 = 3.75, R2 = sign > 0 ? 15.75 : 23.25, l = 9, curvature = 1 / R1 + sign / R2;
      const HertzLine c =
          hertz_line(force, 1e-3 / curvature, l * 1e-3, effective_modulus(kSteel, kSteel));
      const double harris = 3.35e-3 * std::sqrt(force / (l * curvature));
      EXPECT_NEAR(c.half_width * 1e3 / harris, 1, 0.0015);
    }
}

TEST(HertzLine, RefusesWhatIsNoContact) {
  EXPECT_EQ(hertz_line(0, 1, 1, 1).half_width, 0);
  EXPECT_THROW(hertz_line(-1, 1, 1, 1), std::domain_error);
  EXPECT_THROW(hertz_line(1, 0, 1, 1), std::domain_error);
  EXPECT_THROW(hertz_line(1, 1, std::nan(""), 1), std::domain_error);
}

}  // namespace
}  // namespace cagetol
