#include "src/contact/oil_film.hpp"

#include <cmath>

namespace cagetol {

FilmLaw make_film_law(const OilFilm& film, double modulus, double radius, double length,
                      long slices) {
  FilmLaw law;
  law.on = film.model == "series";
  const double slice = length / static_cast<double>(slices);
  law.thickness = 2.65 * std::pow(film.pressure_viscosity, 0.54) * std::pow(film.viscosity, 0.7) *
                  std::pow(radius, 0.43) * std::pow(modulus, -0.03) *
                  std::pow(slice, kFilmForceExponent);
  law.least_force = film.least_force / static_cast<double>(slices);
  return law;
}

}  // namespace cagetol
