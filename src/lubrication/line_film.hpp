// Steady oil film of a line contact in series with the bodies' elasticity, and the squeeze film.
// Per length of the contact:
//
//   h   = (h_E^4 + h_I^4)^(1/4)                                   film thickness [m]
//   h_E = 2.65 alpha^0.54 (eta u)^0.70 R^0.43 E'^-0.03 q^-0.13     elastic, piezoviscous
//   h_I = 4.895 eta u R/q                                         rigid, isoviscous
//   g   = h(q, u) - delta(q),   delta = a q^0.9 + c q              gap of the undeformed bodies [m]
//   s   = 3 sqrt(2) pi eta (R/h)^1.5 (-dh/dt),   dh/dt = h_g dg/dt     squeeze
//   q_f = (s + sqrt(s^2 + 4 q_w^2))/2                             film force
//
// q load per length [N/m], q_w the steady one that follows from g, u entrainment speed (mean of
// both surface speeds as seen from the contact) [m/s], R reduced radius [m], E' = 2/[(1 - nu1^2)/E1
// + (1 - nu2^2)/E2] [Pa], eta viscosity at ambient pressure [Pa s], alpha pressure-viscosity
// coefficient [1/Pa], a elastic approach of the line contact [m (m/N)^0.9], c local compliance of a
// body [m2/N]. g < 0 is penetration. h_g = dh/dg of the steady law: most of a loaded contact's
// approach goes into the bodies, whose own damping acts on d delta/dt = -(1 - h_g) dg/dt.
//
// With q* and h* where h_E = h_I, y = ln(q/q*), D = a q*^0.9/h*, C = c q*/h*, two numbers are left:
//
//   (e^(-0.52 y) + e^(-4 y))^(1/4) - D e^(0.9 y) - C e^y = g/h*
//
// solved from a table's start by exactly two steps of Halley's method: no loop depends on a lane.
// The steady law is monotone and never stiffer than the elastic contact. Isothermal, Newtonian
// inlet, flooded; oil_layer.hpp takes from it what a starved gap lacks.
//
// Sources: Dowson and Higginson, Elasto-hydrodynamic Lubrication (1966); rigid cylinder and squeeze
// of a cylinder against a plane: Reynolds' equation.
#pragma once

#include <numbers>
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
  static constexpr int kGaps = 129, kDepths = 17;
  static constexpr double kFirstGap = -11, kLastGap = 11, kFirstDepth = -5, kLastDepth = 3;
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
  explicit Powers(T y) {             // y as log2
    const T light = exp2(-y), fourth = exp2(-0.13 * y);
    const T e = fourth * fourth, r = light * light;
    elastic = e * e;
    rigid = r * r;
    approach = exp2(0.9 * y);
    load = 1.0 / light;
  }
};

/// log2(q/q*) from the table.
template <class T>
T start(T gap, T log_depth) {
  const FilmTable& table = film_table();
  constexpr double gaps = FilmTable::kGaps - 1, depths = FilmTable::kDepths - 1;
  const T twice = 2.0 * gap, size = abs(twice);
  const T sinh = std::numbers::ln2 * log2(size + sqrt(size * size + 1.0));
  const T place = select(gap < 0.0, -sinh, sinh);
  // Beyond its ends the table goes on along straight lines, which are the limits of light and of
  // heavy loads.
  T share_g, share_d;
  const auto column = [](T x, double first, double last, double cells, T& share) {
    const T at = (x - first) * (cells / (last - first));
    const T inside = min(max(at, T{}), T{} + (cells - 1e-9));
    const auto whole = cell(inside, share);
    share += at - inside;
    return whole;
  };
  const auto i = column(place, FilmTable::kFirstGap, FilmTable::kLastGap, gaps, share_g);
  const auto k = column(log_depth, FilmTable::kFirstDepth, FilmTable::kLastDepth, depths, share_d);
  const auto at = i + k * FilmTable::kGaps;
  const double* low = table.load.data();
  const double* high = low + FilmTable::kGaps;
  const T a = gather(low, at), b = gather(low + 1, at), c = gather(high, at),
          d = gather(high + 1, at);
  const T first = a + share_g * (b - a), second = c + share_g * (d - c);
  return first + share_d * (second - first);
}
}  // namespace line_film_detail

/// `gap` [m], any; `speed` = film_speed(u) > 0.
template <class T>
SteadyFilm<T> steady_film(const LineFilm& film, T gap, T speed) {
  using namespace line_film_detail;
  using V = ValueOf<T>;
  const T log_speed = log2(speed);
  const T log_q = (film.log_ratio + 0.3 * log_speed) * (1 / 0.87);
  const T log_h = film.log_rigid + log_speed - log_q;
  const T h = exp2(log_h), q = exp2(log_q);
  const T log_depth = film.log_approach + 0.9 * log_q - log_h;
  const T depth = exp2(log_depth);
  const T g = gap / h, soft = film.compliance * (q / h);

  const V g0 = value_of(g), D = value_of(depth), C = value_of(soft);
  // Where a local compliance shares the approach, the table is entered with their sum.
  V y = start(g0, film.compliance > 0 ? V(log2(D + C)) : V(value_of(log_depth)));
  for (int step = 0; step < 2; ++step) {
    const Powers<V> p(y);
    const V sum = p.elastic + p.rigid, root = sqrt(sqrt(sum));
    const V rate = -(0.52 * p.elastic + 4.0 * p.rigid) / sum;  // d ln sum/dy
    const V bend = (0.52 * 0.52 * p.elastic + 16.0 * p.rigid) / sum - rate * rate;
    const V a = D * p.approach, c = C * p.load;
    const V f = root - a - c - g0;
    const V slope = 0.25 * root * rate - 0.9 * a - c;
    const V curve = 0.25 * root * (bend + 0.25 * rate * rate) - 0.81 * a - c;
    const V change = f * slope / (slope * slope - 0.5 * f * curve);
    y = y - change * (1 / std::numbers::ln2);
  }
  // One Newton step in the variables' own arithmetic carries their derivatives to y.
  const Powers<V> p(y);
  const V sum = p.elastic + p.rigid, root = sqrt(sqrt(sum));
  const V slope =
      -0.25 * root * (0.52 * p.elastic + 4.0 * p.rigid) / sum - 0.9 * D * p.approach - C * p.load;
  const T miss = root - depth * p.approach - soft * p.load - g;
  const T log_y = y - miss * V(1.0 / (std::numbers::ln2 * slope));

  const Powers<T> e(log_y);
  const T all = e.elastic + e.rigid, inverse = 1.0 / all, thin = sqrt(sqrt(all));
  const T h_y = -0.25 * thin * (0.52 * e.elastic + 4.0 * e.rigid) * inverse;
  SteadyFilm<T> state;
  state.load = q * e.load;
  state.log_load = log_q + log_y;
  state.thickness = h * thin;
  state.opening = h_y / (h_y - 0.9 * depth * e.approach - soft * e.load);
  state.rigidity = e.rigid * inverse;
  return state;
}

/// s at film thickness `h`, which opens at `rate` = dh/dt [N/m].
template <class T>
T squeeze_load(const LineFilm& film, T h, T rate) {
  const T inverse = 1.0 / h;
  return -film.squeeze * rate * inverse * sqrt(inverse);
}

/// q_f of the steady load and the squeeze, both after the layer's factors. Where both vanish the
/// root's slope stays finite.
template <class T>
T film_load(T steady, T squeeze) {
  constexpr double kLeast = 1e-16;  // [N2/m2]
  return 0.5 * (squeeze + sqrt(squeeze * squeeze + 4.0 * steady * steady + kLeast));
}

}  // namespace cagetol
