#include "src/lubrication/traction.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {

Traction make_traction(double viscosity, double pressure_viscosity, double radius, double modulus,
                       double eyring, double limiting, double roughness) {
  for (const double x :
       {viscosity, pressure_viscosity, radius, modulus, eyring, limiting, roughness})
    if (!(x > 0) || !std::isfinite(x))
      throw std::domain_error("traction: every property of oil and surfaces must be positive");
  const double width = 2 * std::sqrt(8 * radius / (std::numbers::pi * modulus));
  return {viscosity, pressure_viscosity, eyring, limiting, roughness, width, radius};
}

}  // namespace cagetol
