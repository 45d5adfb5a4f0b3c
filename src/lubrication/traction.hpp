// Sliding traction of a lubricated line contact, per length, against the sliding velocity du:
//
//   b        = sqrt(8 q R/(pi E')),   p = q/(2 b)           half width, mean pressure (Hertz)
//   eta_p    = eta exp(a),   a = alpha p/(1 + (alpha p/15)^8)^(1/8)
//   tau      = tau_E asinh(eta_p |du|/(tau_E h))
//   tau_film = tau/sqrt(1 + (tau/(Lambda p))^2)
//   F_film   = 2 b tau_film + 2.849 eta |du| sqrt(R/h) c     second term: Couette shear, inlet
//   phi      = 1 - exp(-1.8 lambda^1.2),   lambda = h/roughness
//   F        = phi F_film + (1 - phi) mu_b(|du|) q
//
// q load per length as it acts, squeeze included [N/m], h film thickness [m], tau_E Eyring stress
// [Pa], Lambda limiting shear ratio, c the layer's factor (oil_layer.hpp), mu_b the law of boundary
// friction (src/contact_laws/friction.hpp), the rest as in line_film.hpp. The exponent a is Barus'
// with a smooth cap at 15. Isothermal: heating in the contact, which lowers traction at metres a
// second, is not modelled.
//
// Sources: Eyring, J. Chem. Phys. 4 (1936) 283 (doi 10.1063/1.1749836); Barus, Am. J. Sci. 45
// (1893) 87; Couette term: Reynolds' equation.
#pragma once

#include <cmath>
#include <numbers>

#include "src/contact_laws/friction.hpp"
#include "src/lubrication/line_film.hpp"

namespace cagetol {

struct Traction {
  double viscosity = 0;           ///< eta [Pa s]
  double pressure_viscosity = 0;  ///< alpha [1/Pa]
  double eyring = 5e6;            ///< tau_E [Pa]
  double limiting = 0.06;         ///< Lambda
  double roughness = 0.2e-6;      ///< composite, rms [m]
  double width = 0;               ///< 2 b at q = 1 N/m [m]
  double radius = 0;              ///< R [m]
};

/// Throws std::domain_error unless every number is positive.
Traction make_traction(double viscosity, double pressure_viscosity, double radius, double modulus,
                       double eyring, double limiting, double roughness);

inline constexpr double kSmooth = 12;  ///< lambda from which on 1 - phi, 4e-16, is nothing

namespace traction_detail {
/// asinh(z)/z of z^2, smooth at zero.
template <class T>
T inverse_sinh_ratio(T square) {
  const auto small = square < 1e-4;
  const T series = 1.0 - square * (1.0 / 6 - square * (3.0 / 40 - square * (15.0 / 336)));
  const T large = select(small, T{} + 1.0, square), more = large + 1.0;
  const T inverse = inverse_root(large);
  return select(small, series,
                std::numbers::ln2 * log2(large * inverse + more * inverse_root(more)) * inverse);
}
}  // namespace traction_detail

/// F/|du| [N s/m2]. `load` > 0, `squared` = |du|^2, `couette` = c.
template <class L, class H, class V, class C>
auto traction_ratio(const Traction& law, const FrictionLaw& boundary, L load, H h, V squared,
                    C couette) {
  constexpr double kPerNatural = 1 / std::numbers::ln2;
  const L by_load = inverse_root(load);
  const H by_gap = inverse_root(h);
  const L root = load * by_load, width = law.width * root;
  const L barus = (law.pressure_viscosity / law.width) * root, part = barus * (1.0 / 15);
  const L p2 = part * part, p4 = p2 * p2;
  const L exponent = barus * inverse_root(inverse_root(inverse_root(1.0 + p4 * p4)));
  const auto shear = law.viscosity * exp2(exponent * kPerNatural) * by_gap * by_gap;  // eta_p/h
  const auto newtonian = shear * (1 / law.eyring);
  const auto ratio =
      shear * traction_detail::inverse_sinh_ratio(newtonian * newtonian * squared);  // tau/|du|
  const auto limit = ratio * by_load * (law.width / law.limiting);  // over Lambda p
  const auto film = ratio * inverse_root(1.0 + limit * limit * squared);
  const auto inlet = (2.849 * law.viscosity * std::sqrt(law.radius)) * by_gap * couette;
  const auto oil = width * film + inlet;
  const H lambda = h * (1 / law.roughness);
  const auto rough = lambda < kSmooth;
  if (!any(rough)) return oil;
  const H asperities =
      exp2(power(select(rough, lambda, H{} + 1.0), 1.2) * (-1.8 * kPerNatural));  // 1 - phi
  const auto with =
      (1.0 - asperities) * oil + asperities * friction(boundary, squared).ratio * load;
  return select(rough, with, oil);
}

}  // namespace cagetol
