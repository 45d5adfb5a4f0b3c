// Oil between a roller's spherical roller end and an inclined flange: an elastohydrodynamic point
// contact in series with the bodies' elasticity.
//
//   h   = 2.69 R U^0.67 G^0.53 W^-0.067 (1 - 0.61 e^(-0.73 k)),   k = (R_2/R)^0.64
//   U   = eta u/(E' R),   G = alpha E',   W = F/(E' R^2)
//   g   = h(F, u) - delta(F),   delta = (F/K)^(2/3)         gap of the undeformed bodies [m]
//   F_w = F (1 - (1 - w) h/(h + delta))                     w the layer's factor of the wedge
//
// R reduced radius along the entrainment u and R_2 across it [m], eta, alpha, u, E' as in
// line_film.hpp, K of src/contact_laws/hertz_point.hpp. The starved share is that of the film in
// film and approach, 1 for light loads and 0 for heavy ones. With F* and h* where h = delta and
// y = ln(F/F*) one number is left:
//
//   e^(-0.067 y) - e^(2 y/3) = g/h*
//
// Traction against the sliding velocity du: that of the contact's ellipse, by the laws of
// traction.hpp at the mean pressure p = F/(pi a b), and of the oil around it on the flange's face,
// as wide as the `face` that ends and flange share:
//
//   F_t  = phi (T + C) du + (1 - phi) mu_b F,   T = pi a b tau_film/du
//   C    = 2.849 eta face sqrt(R/h) c
//   M    = phi (T a b/2 + C r^2) w_n
//   r^2  = 2 R (layer - h)/(3 + pi z/2),   z = sqrt(layer/h - 1)
//
// c the layer's factor of Couette shear, w_n the bodies' relative spin about the normal [rad/s], M
// the moment against it; r the radius of gyration of the shear along du, whose integral it follows
// within a sixth. tau and mu_b are those at the speed sqrt(du^2 + (a b/2) w_n^2), the root of the
// mean square over the ellipse. Left out: the moment of boundary friction; squeeze; edges of the
// face that cut the ellipse; load that the oil bears around the ellipse.
//
// Source: Hamrock and Dowson, J. Lubr. Technol. 99 (1977) 264 (doi 10.1115/1.3453074), film in the
// middle of the contact.
#pragma once

#include "src/contact_laws/hertz_point.hpp"
#include "src/lubrication/oil_layer.hpp"
#include "src/lubrication/traction.hpp"

namespace cagetol {

struct PointFilm {
  bool on = false;
  bool shears = true;       ///< traction of the film, else boundary friction
  double layer = 0;         ///< of all oil in the gap [m]
  double log_film = 0;      ///< log2 of h at u = 1 m/s and F = 1 N
  double log_approach = 0;  ///< log2 of delta there
  double area = 0;          ///< pi a b there [m2]
  double inlet = 0;         ///< 2.849 eta face sqrt(R) [N s/m^(1/2)]
  Traction oil;             ///< its radius is R
};

/// `oil` with the properties of oil and surfaces. Throws std::domain_error unless face and layer
/// are positive.
PointFilm make_point_film(const HertzPoint& contact, Traction oil, double face, double layer,
                          bool shears);

/// A film at one gap and speed.
template <class T>
struct PointState {
  T load;       ///< F of a flooded gap [N]
  T thickness;  ///< h [m]
  T approach;   ///< delta [m]
  T opening;    ///< dh/dg, in (0, 1)
};

inline constexpr double kFilmFalls = 0.067;  ///< exponent of the load in the film

/// `speed` = film_speed(u) > 0, `gap` any [m].
template <class T>
PointState<T> point_state(const PointFilm& film, T speed, T gap) {
  using V = ValueOf<T>;
  constexpr double a = kFilmFalls, b = 2.0 / 3;
  const T log_load = (film.log_film - film.log_approach + 0.67 * log2(speed)) * (1 / (a + b));
  const T log_length = film.log_approach + b * log_load;
  const T g = gap * exp2(-log_length);
  // x - x^-m = |g| is the equation on either side of g = 0; Halley's method comes from the left.
  const V size = abs(value_of(g));
  const auto open = value_of(g) > 0.0;
  const V m = select(open, V{} + b / a, V{} + a / b);
  V x = max(size, V{} + 1.0);
  for (int i = 0; i < 5; ++i) {
    const V inverse = reciprocal(x), fall = exp2(-m * log2(x));
    const V f = x - fall - size, slope = 1.0 + m * fall * inverse,
            curve = -m * (m + 1.0) * fall * inverse * inverse;
    x -= 2.0 * f * slope * reciprocal(2.0 * slope * slope - f * curve);
  }
  const V y = log2(x) * select(open, V{} - 1 / a, V{} + 1 / b);
  const V thick = exp2(-a * y), deep = exp2(b * y);
  // Newton's step in the variables' own arithmetic carries their derivatives.
  const T miss = thick - deep - g;
  const T at = y + miss * V((1 / std::numbers::ln2) * reciprocal(a * thick + b * deep));
  PointState<T> state;
  state.load = exp2(log_load + at);
  state.thickness = exp2(log_length - a * at);
  state.approach = exp2(log_length + b * at);
  state.opening = a * state.thickness * reciprocal(a * state.thickness + b * state.approach);
  return state;
}

/// F_w.
template <class T>
T starved_load(const PointState<T>& at, T wedge) {
  const T share = at.thickness * reciprocal(at.thickness + at.approach);
  return at.load * (1.0 - (1.0 - wedge) * share);
}

template <class T>
struct PointFriction {
  T drag;     ///< friction force over sliding speed [N s/m]
  T turning;  ///< moment over relative spin [N m s]
};

/// `load` > 0 as it acts, `squared` the square of the speed in tau and mu_b.
template <class T>
PointFriction<T> point_friction(const PointFilm& film, const FrictionLaw& boundary, T load, T h,
                                T squared) {
  constexpr double kPerNatural = 1 / std::numbers::ln2;
  const T dry = friction(boundary, squared).ratio * load;
  if (!film.shears) return {dry, T{}};
  const Traction& oil = film.oil;
  const T root = power(load, 1.0 / 3), pressure = root * (1 / film.area);
  const T part = (oil.pressure_viscosity / 15) * pressure, p2 = part * part, p4 = p2 * p2;
  const T exponent = 15.0 * part * inverse_root(inverse_root(inverse_root(1.0 + p4 * p4)));
  const T shear = oil.viscosity * exp2(exponent * kPerNatural) * reciprocal(h);
  const T newtonian = shear * (1 / oil.eyring);
  const T tau = shear * traction_detail::inverse_sinh_ratio(newtonian * newtonian * squared);
  const T limit = tau * reciprocal(pressure) * (1 / oil.limiting);
  const T area = film.area * root * root,
          ellipse = area * tau * inverse_root(1.0 + limit * limit * squared);
  const T inverse = inverse_root(h), left = max(film.layer - h, T{} + 1e-6 * film.layer);
  const T around = film.inlet * inverse * oil_factors(h * (1 / film.layer)).couette;
  const T reach = sqrt(left) * inverse;  // z
  const T gyration = 2 * oil.radius * left * reciprocal(3.0 + std::numbers::pi / 2 * reach);
  const T lambda = max(h * (1 / oil.roughness), T{} + 1e-3);
  const T asperities = exp2(power(lambda, 1.2) * (-1.8 * kPerNatural));  // 1 - phi
  return {(1.0 - asperities) * (ellipse + around) + asperities * dry,
          (1.0 - asperities) * (ellipse * area * (0.5 / std::numbers::pi) + around * gyration)};
}

}  // namespace cagetol
