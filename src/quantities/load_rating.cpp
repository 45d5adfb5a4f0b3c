#include "src/quantities/load_rating.hpp"

#include <cmath>

namespace cagetol {
namespace {

constexpr double kMachinedRings = 1.1;  // b_m
constexpr double kPerMetre = 1e3;       // the standards count in mm

}  // namespace

// clang-format off
double geometry_factor(double g) {
  const double rings = std::pow(1.04 * std::pow((1 - g) / (1 + g), 143.0 / 108), 4.5);
  return 0.83 * 207.9 * std::pow(g, 2.0 / 9) * std::pow(1 - g, 29.0 / 27) / std::pow(1 + g, 0.25)
         * std::pow(1 + rings, -2.0 / 9);
}

double dynamic_rating(const RatedRollers& r) {
  return kMachinedRings * geometry_factor(r.diameter / r.pitch_diameter)
         * std::pow(kPerMetre * r.length, 7.0 / 9) * std::pow(static_cast<double>(r.count), 0.75)
         * std::pow(kPerMetre * r.diameter, 29.0 / 27);
}

double static_rating(const RatedRollers& r) {
  return 44 * (1 - r.diameter / r.pitch_diameter) * static_cast<double>(r.count)
         * kPerMetre * r.length * kPerMetre * r.diameter;
}

double rating_life(double dynamic_rating, double load) {
  return 1e6 * std::pow(dynamic_rating / load, 10.0 / 3);
}

double minimum_load_skf(double factor, double speed_ratio, double mean_diameter) {
  const double d = kPerMetre * mean_diameter / 100;
  return 1e3 * factor * (6 + 4 * speed_ratio) * d * d;
}

double minimum_load_schaeffler(double static_rating) {
  return static_rating / 60;
}
// clang-format on

}  // namespace cagetol
