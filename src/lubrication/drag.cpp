#include "src/lubrication/drag.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

constexpr double kAirDensity = 1.2, kAirViscosity = 1.8e-5;
constexpr double kDiscTransition = 3e5, kGapTransition = 2000;
constexpr double kSpan = 0.7;  ///< half width of the blending in ln Re

double blended(double re, double transition, double laminar, double turbulent) {
  const double share = smooth_step((std::log(re / transition) + kSpan) / (2 * kSpan));
  return laminar + share * (turbulent - laminar);
}

}  // namespace

FreeSpaceFluid free_space_fluid(double fill, double oil_density, double oil_viscosity) {
  if (!(fill >= 0 && fill <= 1))
    throw std::domain_error("free space: the share of oil must lie between 0 and 1");
  return {fill * oil_density + (1 - fill) * kAirDensity,
          fill * oil_viscosity + (1 - fill) * kAirViscosity};
}

double disc_coefficient(double re) {
  return blended(re, kDiscTransition, 1.935 / std::sqrt(re), 0.073 * std::pow(re, -0.2));
}

double gap_coefficient(double re) {
  return blended(re, kGapTransition, 2 / re, 0.0791 * std::pow(re, -0.25));
}

double disc_moment(const FreeSpaceFluid& fluid, double w, double outer, double inner) {
  const double speed = std::abs(w);
  if (speed == 0) return 0;
  const double re = fluid.density * outer * outer * speed / fluid.viscosity;
  return 0.5 * fluid.density * w * speed * (std::pow(outer, 5) - std::pow(inner, 5)) *
         disc_coefficient(re);
}

double gap_moment(const FreeSpaceFluid& fluid, double w, double radius, double length, double gap) {
  const double speed = std::abs(w);
  if (speed == 0) return 0;
  const double re = fluid.density * speed * radius * gap / fluid.viscosity;
  const double stress = 0.5 * gap_coefficient(re) * fluid.density * w * speed * radius * radius;
  return stress * 2 * std::numbers::pi * radius * radius * length;
}

}  // namespace cagetol
