#include "src/input/unit.hpp"

#include <gtest/gtest.h>
#include <cmath>
#include <random>

namespace cagetol {
namespace {

TEST(Unit, IsTheSuffixOfTheKey) {
  EXPECT_EQ(unit_of("cage.pocket_width_mm").text, "mm");
  EXPECT_EQ(unit_of("contact.race.damping_N_s_mm").text, "N s/mm");
  EXPECT_EQ(unit_of("friction.static_speed_m_s").text, "m/s");
  EXPECT_EQ(unit_of("environment.gravity_m_s2").text, "m/s^2");
  EXPECT_EQ(unit_of("cage.polar_inertia_kg_mm2").to_si, 1e-6);
  EXPECT_EQ(unit_of("window.settle_time_s").dimension, "time");
  EXPECT_EQ(unit_of("lubrication.viscosity_40_mm2_s").text, "mm^2/s");
  EXPECT_EQ(unit_of("lubrication.conductivity_W_m_K").text, "W/(m K)");
  EXPECT_EQ(unit_of("bearing.roller_count").text, "-");
  EXPECT_EQ(unit_of("friction.static_coefficient").text, "-");
  EXPECT_EQ(without_unit("cage.pocket_width_mm"), "cage.pocket_width");
  EXPECT_EQ(without_unit("cage.model"), "cage.model");
}

TEST(Unit, DecimalsKeepTheBitsThatPeopleMean) {
  EXPECT_EQ(to_si(7.65, 1e-3), 7.65e-3);
  EXPECT_EQ(to_si(43.4, 1e-3), 43.4e-3);
  EXPECT_EQ(to_si(30, 1e-6), 30e-6);
  EXPECT_EQ(to_si(-0.7, 1e-3), -0.7e-3);
  EXPECT_EQ(to_si(750, 1e3), 750e3);
  EXPECT_EQ(to_si(208, 1e9), 208e9);
  EXPECT_EQ(to_si(0, 1e-3), 0);
  EXPECT_EQ(from_si(7.65e-3, 1e-3), 7.65);
  EXPECT_EQ(to_si(6000, 0.10471975511965977), 6000 * 0.10471975511965977);
}

TEST(Unit, ExtremeNumbersSurvive) {
  EXPECT_EQ(to_si(1e308, 1e-3), 1e305);
  EXPECT_EQ(to_si(1e-320, 1e-6), 0);
  EXPECT_EQ(to_si(5e-324, 1e-3), 0);
  EXPECT_TRUE(std::isinf(to_si(1e305, 1e9)));
  EXPECT_TRUE(std::isnan(to_si(std::nan(""), 1e-3)));
  EXPECT_TRUE(std::isinf(to_si(INFINITY, 1e-3)));
}

TEST(Unit, ConversionIsWithinOneRounding) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::pow(10, exponent(random)) * (i % 2 ? 1 : -1);
    EXPECT_DOUBLE_EQ(to_si(value, 1e-3), value * 1e-3);
    EXPECT_DOUBLE_EQ(from_si(to_si(value, 1e-6), 1e-6), value);
    EXPECT_EQ(to_si(unit_value(value, 1), 1), value);
  }
}

TEST(Unit, TheValueInItsUnitGivesTheSameBitsInSI) {
  EXPECT_EQ(to_si(unit_value(to_si(13.387664401253275, 1e-3), 1e-3), 1e-3),
            to_si(13.387664401253275, 1e-3));
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> exponent(-12, 12);
  for (int i = 0; i < 20000; ++i)
    for (const double factor : {1e-3, 1e-6, 1e9, 0.10471975511965977}) {
      const double si = to_si(std::pow(10, exponent(random)), factor);
      EXPECT_EQ(to_si(unit_value(si, factor), factor), si);
    }
}

}  // namespace
}  // namespace cagetol
