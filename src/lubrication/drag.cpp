#include "src/lubrication/drag.hpp"

#include <stdexcept>

namespace cagetol {

FreeSpaceFluid free_space_fluid(double fill, double oil_density, double oil_viscosity) {
  constexpr double kAirDensity = 1.2, kAirViscosity = 1.8e-5;
  if (!(fill >= 0 && fill <= 1))
    throw std::domain_error("free space: the share of oil must lie between 0 and 1");
  return {fill * oil_density + (1 - fill) * kAirDensity,
          fill * oil_viscosity + (1 - fill) * kAirViscosity};
}

}  // namespace cagetol
