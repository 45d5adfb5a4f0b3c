// Steady oil film of a line contact in series with the bodies' elasticity, and the squeeze film.
// Per length of the contact:
//
//   h   = (h_E^4 + h_I^4)^(1/4)                                   film thickness [m]
//   h_E = 2.65 alpha^0.54 (eta u)^0.70 R^0.43 E'^-0.03 q^-0.13     elastic, piezoviscous
//   h_I = 4.895 eta u R/q                                         rigid, isoviscous
//   g   = h(q, u) - delta(q),   delta = a q^0.9 + c q              gap of the undeformed bodies [m]
//   s   = 3 sqrt(2) pi eta (R/h)^1.5 (-dh/dt),   dh/dt = h_g dg/dt     squeeze
//   q_f = (s + sqrt(s^2 + 4 q_w^2))/2                             film force
//   E'  = 2/[(1 - nu1^2)/E1 + (1 - nu2^2)/E2]                     effective modulus [Pa]
//
// q load per length [N/m], q_w the steady one that follows from g, u entrainment speed (mean of
// both surface speeds as seen from the contact) [m/s], R reduced radius [m], eta viscosity at
// ambient pressure [Pa s], alpha pressure-viscosity coefficient [1/Pa], a elastic approach of the
// line contact [m (m/N)^0.9], c local compliance of a body [m2/N]. g < 0 is penetration.
// h_g = dh/dg of the steady law: most of a loaded contact's approach goes into the bodies, whose
// own damping acts on
//   d delta/dt = -(1 - h_g) dg/dt
//
// With q* and h* where h_E = h_I, y = ln(q/q*), D = a q*^0.9/h*, C = c q*/h*, two numbers are left:
//
//   (e^(-0.52 y) + e^(-4 y))^(1/4) - D e^(0.9 y) - C e^y = g/h*
//
// solved from a table's start by exactly one step of Halley's method (two where C > 0, whose start
// is rougher) and one of Newton's; no loop depends on a lane. How well that gives the load back:
// tests/unit/src/line_film_test.cpp. The steady law is monotone and never stiffer than the elastic
// contact.
// Isothermal, Newtonian inlet, flooded; oil_layer.hpp takes from it what a starved gap lacks.
//
// Sources: Dowson and Higginson, Elasto-hydrodynamic Lubrication (1966); rigid cylinder and squeeze
// of a cylinder against a plane: Reynolds' equation.
#pragma once

#include <numbers>
#include <utility>
#include <vector>

#include "src/numerics/dual.hpp"

namespace cagetol {

inline constexpr double kSlowestFilm = 0.01;  ///< u0 [m/s]

/// sqrt(u^2 + u0^2): films and rolling forces see no slower entrainment [m/s].
template <class T>
T film_speed(T u) {
  return sqrt(u * u + kSlowestFilm * kSlowestFilm);
}

/// Start of the solution: ln(q/q*) over asinh(2 g/h*) and log2 D.
struct FilmTable {
  static constexpr int kGaps = 321, kDepths = 25;
  static constexpr double kFirstGap = -15, kLastGap = 15, kFirstDepth = -7, kLastDepth = 5;
  std::vector<double> load;  ///< gaps next to each other
};
const FilmTable& film_table();

/// One line contact of given bodies and oil.
struct LineFilm {
  double viscosity = 0;     ///< eta [Pa s]
  double radius = 0;        ///< R [m]
  double modulus = 0;       ///< E' [Pa]
  double compliance = 0;    ///< c [m2/N]
  double elastic = 0;       ///< h_E at u = 1 m/s and q = 1 N/m [m]
  double rigid = 0;         ///< h_I there [m]
  double approach = 0;      ///< a [m (m/N)^0.9]
  double log_ratio = 0;     ///< log2(rigid/elastic)
  double log_rigid = 0;     ///< log2(rigid)
  double log_approach = 0;  ///< log2(a)
  double squeeze = 0;       ///< 3 sqrt(2) pi eta R^1.5 [N s/m^(1/2)]
};

/// `approach`: a. Throws std::domain_error unless all but `compliance` (>= 0) are positive.
LineFilm make_line_film(double viscosity, double pressure_viscosity, double radius, double modulus,
                        double approach, double compliance = 0);

/// A steady film at one gap and speed.
template <class T>
struct SteadyFilm {
  T load;       ///< q_w, of a flooded gap [N/m]
  T log_load;   ///< log2 q_w
  T thickness;  ///< h [m]
  T opening;    ///< h_g = dh/dg, in (0, 1)
  T rigidity;   ///< (h_I/h)^4: 1 for light loads, 0 for heavy ones
};

/// Film of a load [m].
inline double film_thickness(const LineFilm& film, double q, double speed) {
  const double e = film.elastic * power(speed, 0.7) * power(q, -0.13), i = film.rigid * speed / q;
  return power(e * e * e * e + i * i * i * i, 0.25);
}

namespace line_film_detail {
/// The three exponentials of the solution's equation.
template <class T>
struct Powers {
  T elastic, rigid, approach, load;  ///< e^(-0.52 y), e^(-4 y), e^(0.9 y), e^y
};
template <class V>
Powers<V> powers(V y) {  // y as log2
  const V light = exp2(-y), fourth = exp2(-0.13 * y);
  const V e = fourth * fourth, r = light * light;
  return {e * e, r * r, exp2(0.9 * y), reciprocal(light)};
}
/// e^x of a small x, up to its term of that order.
template <int order, class T>
T growth(T x) {
  T sum = x * (1.0 / order) + 1.0;
  for (int n = order - 1; n > 0; --n) sum = sum * (x * (1.0 / n)) + 1.0;
  return sum;
}
/// At y + `move`; right to 1e-15 where that is below 0.03, as it is within the table.
template <class V>
Powers<V> moved(const Powers<V>& p, V move) {
  const V light = growth<8>(-move), fourth = growth<5>(-0.13 * move);
  const V e = fourth * fourth, r = light * light;
  return {p.elastic * (e * e), p.rigid * (r * r), p.approach * growth<7>(0.9 * move),
          p.load * growth<8>(move)};
}

/// Halley's step in y: f = root - D e^(0.9 y) - C e^y - g.
template <class V>
V halley(const Powers<V>& p, V depth, V soft, V gap) {
  const V sum = p.elastic + p.rigid, inverse_root_sum = inverse_root(sum);
  const V inverse = inverse_root_sum * inverse_root_sum, root = inverse_root(inverse_root_sum);
  const V rate = -(0.52 * p.elastic + 4.0 * p.rigid) * inverse;  // d ln sum/dy
  const V bend = (0.52 * 0.52 * p.elastic + 16.0 * p.rigid) * inverse - rate * rate;
  const V deep = depth * p.approach, more = soft * p.load;
  const V f = root - deep - more - gap;
  const V slope = 0.25 * root * rate - 0.9 * deep - more;
  const V curve = 0.25 * root * (bend + 0.25 * rate * rate) - 0.81 * deep - more;
  return -f * slope * reciprocal(slope * slope - 0.5 * f * curve);
}

/// Place x between the table's lines: the line's number, the rest into `share`. Beyond its ends the
/// table goes on along straight lines, which are the limits of light and of heavy loads.
template <class V>
auto line(V x, double first, double last, double cells, V& share) {
  const V at = (x - first) * (cells / (last - first));
  const V inside = min(max(at, V{}), V{} + (cells - 1e-9));
  const auto whole = cell(inside, share);
  share += at - inside;
  return whole;
}
}  // namespace line_film_detail

/// What a film makes of its speed alone, for all gaps.
template <class T>
struct FilmScale {
  T log_speed;    ///< log2 u_s
  T log_load;     ///< log2 q*
  T load;         ///< q* [N/m]
  T length;       ///< h* [m]
  T inverse;      ///< 1/h*
  T depth, soft;  ///< D, C
  /// Row of the table at or below D, and how far beyond it D lies, in rows.
  decltype(cell(ValueOf<T>{}, std::declval<ValueOf<T>&>())) row;
  ValueOf<T> share;
  int steps;            ///< of Halley's method
  const double* table;  ///< of film_table()
};
/// `speed` = film_speed(u) > 0.
template <class T>
FilmScale<T> film_scale(const LineFilm& film, T speed) {
  using V = ValueOf<T>;
  FilmScale<T> scale;
  scale.log_speed = log2(speed);
  scale.log_load = (film.log_ratio + 0.3 * scale.log_speed) * (1 / 0.87);
  const T log_h = film.log_rigid + scale.log_speed - scale.log_load;
  scale.load = exp2(scale.log_load);
  scale.length = exp2(log_h);
  scale.inverse = exp2(-log_h);
  const T log_depth = film.log_approach + 0.9 * scale.log_load - log_h;
  scale.depth = exp2(log_depth);
  scale.soft = film.compliance * (scale.load * scale.inverse);
  // Where a local compliance shares the approach, the table is entered with their sum.
  const V place = film.compliance > 0 ? V(log2(value_of(scale.depth) + value_of(scale.soft)))
                                      : V(value_of(log_depth));
  scale.row = line_film_detail::line(place, FilmTable::kFirstDepth, FilmTable::kLastDepth,
                                     FilmTable::kDepths - 1.0, scale.share);
  scale.steps = film.compliance > 0 ? 2 : 1;
  scale.table = film_table().load.data();
  return scale;
}

/// `gap` [m], any.
template <class U, class G>
auto steady_film(const FilmScale<U>& scale, G gap) {
  using namespace line_film_detail;
  using T = decltype(gap * scale.inverse);
  using V = ValueOf<T>;
  const T g = gap * scale.inverse;
  const V g0 = value_of(g), D = value_of(scale.depth), C = value_of(scale.soft);

  // log2(q/q*) from the table, over asinh(2 g).
  const V size = abs(2.0 * g0), square = size * size + 1.0;
  const V sinh = std::numbers::ln2 * log2(size + square * inverse_root(square));
  V share;
  const auto column = line(select(g0 < 0.0, -sinh, sinh), FilmTable::kFirstGap, FilmTable::kLastGap,
                           FilmTable::kGaps - 1.0, share);
  const auto at = column + scale.row * FilmTable::kGaps;
  const double *low = scale.table, *high = low + FilmTable::kGaps;
  const V a = gather(low, at), b = gather(low + 1, at), c = gather(high, at),
          d = gather(high + 1, at);
  const V first = a + share * (b - a), second = c + share * (d - c);
  V y = first + scale.share * (second - first);
  Powers<V> p = powers(y);
  V change = halley(p, D, C, g0);
  if (scale.steps > 1) {
    y += change * (1 / std::numbers::ln2);
    p = powers(y);
    change = halley(p, D, C, g0);
  }
  y += change * (1 / std::numbers::ln2);
  p = scale.steps > 1 ? powers(y) : moved(p, change);

  // Newton's step in the variables' own arithmetic carries their derivatives to y.
  const V near = p.elastic + p.rigid, inverse_root_near = inverse_root(near);
  const V inverse_near = inverse_root_near * inverse_root_near;
  const V root = inverse_root(inverse_root_near);
  const V slope = -0.25 * root * (0.52 * p.elastic + 4.0 * p.rigid) * inverse_near -
                  0.9 * D * p.approach - C * p.load;
  const T miss = root - scale.depth * p.approach - scale.soft * p.load - g;
  const T move = miss * V(-reciprocal(slope));

  // All that follows from y at y + move, with its slope by y.
  const V last = value_of(move);
  const V elastic = p.elastic * growth<3>(-0.52 * last), rigid = p.rigid * growth<3>(-4.0 * last),
          approach = p.approach * growth<3>(0.9 * last), load = p.load * growth<3>(last);
  const V more = (elastic + rigid) * inverse_near - 1.0;  // of the sum
  const V inverse = inverse_near * (1.0 - more * (1.0 - more * (1.0 - more)));
  const V thin = root * (1.0 + more * (0.25 - more * (3.0 / 32 - more * (7.0 / 128))));
  const V rate = -(0.52 * elastic + 4.0 * rigid) * inverse;  // d ln sum/dy
  const V bend = (0.52 * 0.52 * elastic + 16.0 * rigid) * inverse - rate * rate;
  const V thin_y = 0.25 * thin * rate, rigidity = rigid * inverse;
  const T h_y = follow(move, thin_y, V(0.25 * (thin * bend + thin_y * rate)));
  const T q = follow(move, load, load);
  SteadyFilm<T> state;
  state.load = scale.load * q;
  state.log_load = scale.log_load + y + move * (1 / std::numbers::ln2);
  state.thickness = scale.length * follow(move, thin, thin_y);
  state.rigidity = follow(move, rigidity, V(rigidity * (-4.0 - rate)));
  state.opening =
      h_y * reciprocal(h_y - scale.depth * follow(move, V(0.9 * approach), V(0.81 * approach)) -
                       scale.soft * q);
  return state;
}

/// s at film thickness `h`, which opens at `rate` = dh/dt [N/m].
template <class H, class R>
auto squeeze_load(const LineFilm& film, H h, R rate) {
  const H inverse = inverse_root(h);
  return -film.squeeze * rate * inverse * inverse * inverse;
}

/// q_f of the steady load and the squeeze, both after the layer's factors. Where both vanish the
/// root's slope stays finite.
template <class Q, class S>
auto film_load(Q steady, S squeeze) {
  constexpr double kLeast = 1e-16;  // [N2/m2]
  const auto square = squeeze * squeeze + 4.0 * steady * steady + kLeast;
  return 0.5 * (squeeze + square * inverse_root(square));
}

}  // namespace cagetol
