// Oil between two flats, a roller's end and the wall that it faces:
//
//   squeeze   F = r(s),   s = k S(x) (-dg/dt)/h^3,   k = 3 eta A^2/(2 pi)    disc of equal area
//   shear     F = c |du|,   c = eta A/h C(x)                                  Couette
//
// g gap of the flats, h height of the film in it [m], A area [m2], S and C what the layer leaves of
// them (oil_layer.hpp, x = h/layer). There is no wedge. r(s) = (s + sqrt(s^2 + 4 f^2))/2 - f lets
// the film push and hardly pull: it ruptures at f, a thousandth of a newton. Roughness ends the
// film: below two `least` heights of gap, h shrinks ever more slowly and never below `least`; there
// the bodies touch, by their own law. Sources: Hamrock, Fundamentals of Fluid Film Lubrication,
// squeeze film of parallel discs.
#pragma once

#include "src/lubrication/oil_layer.hpp"

namespace cagetol {

struct FlatFilm {
  bool on = false;
  double squeeze = 0;  ///< k [N s m2]; 0: no squeeze
  double shear = 0;    ///< eta A [N s]
  double layer = 0;    ///< of all oil in the gap [m]
  double least = 0;    ///< roughness [m]
};

/// Of one of `points` equal parts of a flat of `area`. Throws std::domain_error unless viscosity,
/// layer and least are positive and the area is not negative.
FlatFilm make_flat_film(double viscosity, double area, double layer, double least, int points,
                        bool squeeze);

template <class T>
struct FlatFilmForces {
  T normal;  ///< of the squeeze, pushing the flats apart [N]
  T drag;    ///< c [N s/m]
};

/// `gap` of the smooth flats [m], negative where they touch; `rate` of it [m/s].
template <class T>
FlatFilmForces<T> flat_film(const FlatFilm& law, T gap, T rate) {
  constexpr double kRupture = 1e-3;  // [N]
  const auto rough = gap < 2 * law.least;
  const T deeper = 3.0 - select(rough, gap, T{} + 2 * law.least) * (1 / law.least);
  const T height = select(rough, law.least + law.least / deeper, gap);
  const OilFactors<T> oil = oil_factors(height * (1 / law.layer));
  const T s = law.squeeze * oil.squeeze * (-rate) / (height * height * height);
  return {0.5 * (s + sqrt(s * s + 4 * kRupture * kRupture)) - kRupture,
          law.shear * oil.couette / height};
}

}  // namespace cagetol
