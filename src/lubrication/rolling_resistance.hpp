// Hydrodynamic rolling resistance of a line contact. Oil drawn into the inlet is pushed back by the
// pressure, which pulls on EACH of the two surfaces against its motion as seen from the contact.
// Per length:
//
//   f   = (f_E^-3 + f_I^-3)^(-1/3)                                             [N/m]
//   f_I = 2.0796 sqrt(eta u q)                                                 rigid, isoviscous
//   f_E = 4.317 (alpha eta u/R)^0.658228 W^0.012658 R/alpha,   W = q/(E' R)     elastic, isothermal
//   f_E = W K R/alpha                                                          with inlet heating
//         ln K = (0.658228 + 0.0106383 L^0.3174603) ln D - (0.162625 + ln(1 + 0.411483 L^0.707071))
//         D    = 11.81220746 alpha E' (eta u/(E' R))/W^1.5,   L = eta beta u^2/k
//
// q steady load of a flooded gap, without squeeze [N/m], u entrainment speed [m/s],
// beta = -d ln nu/dT [1/K], k conductivity of the oil [W/(m K)]; the rest as in line_film.hpp. At
// L = 0 the line with K is the one above it.
//
// The pressure is not symmetric about the contact, so each body also feels a force through its own
// axis. A roller gets f (2 R/R_roller - 1) along the surfaces' motion and the moment f R_roller
// against its spin, the other body the opposite force; the power lost is f (u1 + u2) = 2 f u.
//
// Sources: Goksem and Hargreaves, J. Lubr. Technol. 100 (1978) 346 and 353;
// f_I: Reynolds' equation, rigid cylinder.
#pragma once

#include <numbers>

#include "src/lubrication/line_film.hpp"

namespace cagetol {

struct RollingResistance {
  bool heating = false;
  double rigid = 0;           ///< f_I at u = 1 m/s, q = 1 N/m [N/m]
  double log_elastic = 0;     ///< log2 f_E there, isothermal
  double log_drag = 0;        ///< log2 D there
  double log_load_scale = 0;  ///< log2 of W R/alpha there
  double log_heating = 0;     ///< log2 L at u = 1 m/s
};

/// `viscosity_fall`: beta, `conductivity`: k; both used where `heating`.
RollingResistance make_rolling_resistance(double viscosity, double pressure_viscosity,
                                          double radius, double modulus, bool heating,
                                          double viscosity_fall, double conductivity);

/// What rolling resistance makes of the speed alone: log2 f_E = power log2 q + elastic.
template <class T>
struct RollingScale {
  T power, elastic;
  T rigid;  ///< f_I at q = 1 N/m [N/m]
};
/// `speed` = film_speed(u) with `log_speed` = log2 of it.
template <class T>
RollingScale<T> rolling_scale(const RollingResistance& law, T speed, T log_speed) {
  constexpr double kSpeed = 0.658228, kLoad = 0.012658;
  RollingScale<T> scale;
  scale.rigid = law.rigid * sqrt(speed);
  if (law.heating) {
    const T log_L = law.log_heating + 2.0 * log_speed;
    const T grade = kSpeed + 0.0106383 * exp2(0.3174603 * log_L);
    scale.power = 1.0 - 1.5 * grade;
    scale.elastic = law.log_load_scale + grade * (law.log_drag + log_speed) -
                    0.162625 / std::numbers::ln2 - log2(1.0 + 0.411483 * exp2(0.707071 * log_L));
  } else {
    scale.power = T{} + kLoad;
    scale.elastic = law.log_elastic + kSpeed * log_speed;
  }
  return scale;
}

/// x^(-1/3) for x from 1 to 2, within 1e-15: a parabola, then Newton's steps.
template <class T>
T inverse_cube_root(T x) {
  const T more = x - 1.0;
  T y = 1.0 - more * (0.3115 - more * 0.1056);
  for (int step = 0; step < 3; ++step) y = y * ((4.0 / 3) - (1.0 / 3) * x * (y * y * y));
  return y;
}

/// f [N/m]. `load` = q_w > 0 with `log_load` = log2 of it.
template <class U, class T>
T rolling_resistance(const RollingScale<U>& scale, T load, T log_load) {
  const T elastic = exp2(scale.power * log_load + scale.elastic);
  const T rigid = scale.rigid * (load * inverse_root(load));
  // Scaled by the smaller of the two: neither cube may leave the range of numbers.
  const T less = min(elastic, rigid), share = less * reciprocal(max(elastic, rigid));
  return less * inverse_cube_root(share * share * share + 1.0);
}

}  // namespace cagetol
