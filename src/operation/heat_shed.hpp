// Heat that a bearing sheds to its surroundings and to the oil that flows through it, at the
// temperature T of its outer ring and of that oil as it leaves:
//
//   P(T) = G (T - T_a) + rho c V (T - T_in)
//   G = q_r A/50 K,   A = pi B (d + D),   q_r = 0.016 W/mm2 (A/50,000 mm2)^-0.34, at most 0.016
//
// T_a ambient, V flow of oil, T_in its temperature at the inlet, B, d, D width, bore and outside.
// Source: ISO 15312, Rolling bearings, thermal speed rating: reference conditions of radial
// bearings (50 K above 20 degC); c = 2000 J/(kg K), mineral oil.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

struct HeatShed {
  double slope;  ///< dP/dT = G + rho c V [W/K]
  double zero;   ///< T at which nothing is shed [degC]
  double at(double temperature) const { return slope * (temperature - zero); }  ///< [W]
};
HeatShed heat_shed(const Scene& scene);

/// rho c of its oil [J/(m^3 K)].
double oil_heat_capacity(const Scene& scene);

/// The scene with oil and outer ring at `temperature`, the inner ring above it [degC].
Scene at_temperature(Scene scene, double temperature);

}  // namespace cagetol
