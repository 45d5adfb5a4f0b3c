// All that a lubricated line contact does at one gap: steady film in series with the elastic
// contact, squeeze, damping of the bodies, rolling resistance and sliding traction, starved by the
// layer.
//
//   Q   = L max(0, q_f + q_w chi d delta/dt)            normal force [N]
//   q_f = (s + sqrt(s^2 + 4 q_w^2))/2,   s squeeze      (line_film.hpp), with dh/dt = h_g dg/dt
//   q_w = q times what the layer leaves of it           (oil_layer.hpp)
//   d delta/dt = -(1 - h_g) dg/dt                       approach of the bodies
//   F_t = -ratio du                                     traction at the load as it acts
//   F_r = f L (u/u_s) R                                 rolling force, along u
//
// chi of Hunt and Crossley (src/contact_laws/normal_force.hpp), ratio of traction.hpp, f of
// rolling_resistance.hpp.
//
// Powers, each what the bodies lose to the contact: sliding ratio |du|^2, rolling 2 F_r u, normal
// Q (-dg/dt), of which squeeze (q_f - q_w) L (-dg/dt) and damping (Q - q_f L)(-dg/dt) are lost for
// good and the rest is stored in the bodies (elastic_store) or exchanged with the film, which is
// not conservative: its thickness follows u.
#pragma once

#include <cmath>

#include "src/lubrication/oil_layer.hpp"
#include "src/lubrication/rolling_resistance.hpp"
#include "src/lubrication/traction.hpp"

namespace cagetol {

struct LubricatedLine {
  bool starved = false;  ///< a layer of oil, else flooded
  bool squeeze = true;
  bool rolls = true;   ///< rolling resistance
  bool shears = true;  ///< traction of the film, else boundary friction
  double layer = 0;    ///< of all oil in the gap [m]
  double length = 0;   ///< of this contact, or of one slice [m]
  double chi = 0;      ///< Hunt-Crossley [s/m]
  LineFilm film;
  RollingResistance rolling;
  Traction traction;
  FrictionLaw boundary;
};

/// What a contact makes of its entrainment speed alone, for all slices of a roller.
template <class T>
struct LineSpeed {
  T direction;  ///< u/u_s
  FilmScale<T> film;
  RollingScale<T> rolling;
};
/// `u` entrainment speed, signed [m/s].
template <class T>
LineSpeed<T> line_speed(const LubricatedLine& law, T u) {
  const T speed = film_speed(u);
  LineSpeed<T> at;
  at.direction = u * reciprocal(speed);
  at.film = film_scale(law.film, speed);
  if (law.rolls) at.rolling = rolling_scale(law.rolling, speed, at.film.log_speed);
  return at;
}

/// Steady film of a load per length `q` > 0 [m].
inline double loaded_film(const LubricatedLine& law, double q, double speed) {
  const double h = film_thickness(law.film, q, speed), rigid = law.film.rigid * speed / (q * h);
  return law.starved ? layered(h, std::pow(rigid, 4), 0.0, law.layer).thickness : h;
}

/// The normal force alone, and what traction and rolling need of it. S: what depends on gap and
/// speed, T: on the gap's rate, too.
template <class S, class T = S>
struct LineNormal {
  T normal;             ///< Q >= 0 [N]
  T acting;             ///< Q/L [N/m]
  S steady;             ///< q_w L [N]
  T film;               ///< q_f L [N]
  SteadyFilm<S> state;  ///< as if flooded
  LayeredFilm<S> oil;
};

/// `gap` of the undeformed bodies and its `rate` [m], [m/s].
template <class U, class G, class R>
auto line_normal(const LubricatedLine& law, const LineSpeed<U>& speed, G gap, R rate) {
  using S = decltype(gap * speed.film.inverse);
  using T = decltype(gap * speed.film.inverse * rate);
  LineNormal<S, T> n;
  n.state = steady_film(speed.film, gap);
  const SteadyFilm<S>& at = n.state;
  n.oil = law.starved ? layered(at.thickness, at.rigidity, gap, law.layer) : flooded(at.thickness);
  const S steady = at.load * n.oil.load;
  T film = steady;
  if (law.squeeze)
    film = film_load(steady,
                     n.oil.of.squeeze * squeeze_load(law.film, at.thickness, at.opening * rate));
  n.acting = max(film - steady * law.chi * (1.0 - at.opening) * rate, T{});
  n.normal = law.length * n.acting;
  n.steady = law.length * steady;
  n.film = law.length * film;
  return n;
}

/// What the bodies store by their approach delta, and the force that stores it as the gap closes.
template <class T>
struct ElasticStore {
  T energy;  ///< L 0.9/1.9 q delta [J]
  T force;   ///< -d(energy)/d(gap) [N]
};
/// `depth` = -gap.
template <class S, class T, class G>
ElasticStore<S> elastic_store(const LubricatedLine& law, const LineNormal<S, T>& n, G depth) {
  const S q = law.length * n.state.load;
  return {(0.9 / 1.9) * q * (n.state.thickness + depth), q * (1.0 - n.state.opening)};
}

template <class S, class T = S, class A = T>
struct LineForces {
  LineNormal<S, T> at;
  A ratio;    ///< traction over sliding speed [N s/m]
  S rolling;  ///< F_r, signed as u: on each surface against its motion [N]
};

/// `squared` = |du|^2.
template <class U, class G, class R, class V>
auto line_forces(const LubricatedLine& law, const LineSpeed<U>& speed, G gap, R rate, V squared) {
  using S = decltype(gap * speed.film.inverse);
  using T = decltype(gap * speed.film.inverse * rate);
  LineForces<S, T, decltype(T{} * squared)> forces;
  forces.at = line_normal(law, speed, gap, rate);
  const LineNormal<S, T>& n = forces.at;
  // A contact that carries nothing slides without traction: the law's load must stay above zero.
  const T load = max(n.acting, T{} + 1e-6);
  if (law.shears)
    forces.ratio = law.length * traction_ratio(law.traction, law.boundary, load, n.oil.thickness,
                                               squared, n.oil.of.couette);
  else
    forces.ratio = law.length * friction(law.boundary, squared).ratio * n.acting;
  forces.rolling = S{};
  if (law.rolls)
    forces.rolling = law.length * n.oil.of.rolling * speed.direction *
                     rolling_resistance(speed.rolling, n.state.load, n.state.log_load);
  return forces;
}

}  // namespace cagetol
