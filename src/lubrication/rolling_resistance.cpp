#include "src/lubrication/rolling_resistance.hpp"

#include <cmath>
#include <stdexcept>

namespace cagetol {

RollingResistance make_rolling_resistance(double viscosity, double pressure_viscosity,
                                          double radius, double modulus, bool heating,
                                          double viscosity_fall, double conductivity) {
  for (const double x : {viscosity, pressure_viscosity, radius, modulus})
    if (!(x > 0) || !std::isfinite(x))
      throw std::domain_error("rolling resistance: viscosity, radius and modulus must be positive");
  if (heating && !(viscosity_fall > 0 && conductivity > 0))
    throw std::domain_error(
        "rolling resistance: inlet heating needs the fall of viscosity and the conductivity");
  RollingResistance law;
  law.heating = heating;
  const double G = pressure_viscosity * viscosity / radius, W = 1 / (modulus * radius);
  law.log_elastic = std::log2(4.317 * std::pow(G, 0.658228) * std::pow(W, 0.012658) * radius /
                              pressure_viscosity);
  law.rigid = 2.0796 * std::sqrt(viscosity);
  law.log_drag = std::log2(11.81220746 * G / std::pow(W, 1.5));
  law.log_load_scale = std::log2(W * radius / pressure_viscosity);
  if (heating) law.log_heating = std::log2(viscosity * viscosity_fall / conductivity);
  return law;
}

}  // namespace cagetol
