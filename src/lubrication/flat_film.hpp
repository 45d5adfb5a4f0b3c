// Oil between two flats, a roller's end and the wall or flange that it faces:
//
//   normal    F = r(s + w)
//   squeeze   s = k S(x) (-dg/dt)/h^3,   k = 3 eta A^2/(2 pi)    disc of equal area
//   wedge     w = m W(x) |u|/h^2,        m = (3/16) eta b^3      narrow pad
//   shear     c |du|,                    c = eta A/h C(x)        Couette
//
// g gap of the flats, h height of the film in it [m], A area [m2], b width of the pad across the
// motion, u mean speed of both surfaces along it [m/s], S, C and W what the layer leaves of them
// (oil_layer.hpp, x = h/layer). r(s) = (s + sqrt(s^2 + 4 f^2))/2 - f lets the film push and hardly
// pull: it ruptures at f, a thousandth of a newton. |u| is rounded within a millimetre per second.
//
// The wedge is that of a pad which leans by its own film thickness, from 2 h where oil enters to h.
// A pad much longer than wide has p = 3 eta u h' (b^2/4 - y^2)/h^3 across it, hence
// F = eta u b^3/4 (1/h^2 - 1/(2 h)^2), whatever the shape of the gap in between. A plane pad of
// that kind shears ln 2 of what one at the height h would.
//
// Roughness ends the film: h never falls below l, the `least` height, whatever the gap; there the
// bodies touch, by their own law:
//   h = (g + l)/2 + sqrt((g - l)^2/4 + (0.3 l)^2)
// Sources: Hamrock, Fundamentals of Fluid Film Lubrication: squeeze film of parallel discs; narrow
// bearing approximation of Reynolds' equation.
#pragma once

#include "src/lubrication/oil_layer.hpp"

namespace cagetol {

struct FlatFilm {
  bool on = false;
  double squeeze = 0;  ///< k [N s m2]; 0: no squeeze
  double shear = 0;    ///< eta A [N s]
  double wedge = 0;    ///< m [N s m]; 0: no wedge
  double layer = 0;    ///< of all oil in the gap [m]
  double minimum = 0;  ///< roughness [m]
};

/// Of one of `points` equal parts of a flat of `area`. Throws std::domain_error unless viscosity,
/// layer and least are positive and the area is not negative.
FlatFilm make_flat_film(double viscosity, double area, double layer, double minimum, int points,
                        bool squeeze);
/// That film between pads `width` wide that draw oil in, in equal parts.
FlatFilm with_wedge(FlatFilm film, double viscosity, double width, int points);

/// h of a gap.
template <class T>
T film_height(const FlatFilm& law, T gap) {
  const double l = law.minimum, bend = 0.3 * l;
  const T half = 0.5 * (gap - l);
  const T root = sqrt(half * half + bend * bend), away = root + max(half, -half);
  return l + select(half < 0.0, bend * bend / away, away);  // free of cancellation
}

template <class T>
struct FlatFilmForces {
  T normal;  ///< pushing the flats apart [N]
  T drag;    ///< c [N s/m]
};

/// `gap` of the smooth flats [m], negative where they touch; `rate` of it [m/s], `wedge` w [N].
template <class T>
FlatFilmForces<T> flat_film(const FlatFilm& law, T gap, T rate, T wedge = T{}) {
  constexpr double kRupture = 1e-3;  // [N]
  const T height = film_height(law, gap);
  const OilFactors<T> oil = oil_factors(height * (1 / law.layer));
  const T s = law.squeeze * oil.squeeze * (-rate) / (height * height * height) + wedge;
  return {0.5 * (s + sqrt(s * s + 4 * kRupture * kRupture)) - kRupture,
          law.shear * oil.couette / height};
}

/// w [N]; `speed` u [m/s].
template <class T>
T flat_wedge(const FlatFilm& law, T gap, T speed) {
  constexpr double kRounded = 1e-3;  // [m/s]
  const T height = film_height(law, gap);
  const T magnitude = sqrt(speed * speed + kRounded * kRounded) - kRounded;
  return law.wedge * oil_factors(height * (1 / law.layer)).wedge * magnitude / (height * height);
}

}  // namespace cagetol
