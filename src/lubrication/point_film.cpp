#include "src/lubrication/point_film.hpp"

#include <cmath>
#include <stdexcept>

namespace cagetol {

PointFilm make_point_film(const HertzPoint& contact, Traction oil, double face, double layer,
                          bool shears) {
  if (!(face > 0 && layer > 0))
    throw std::domain_error("point film: face and oil layer must be positive");
  const double R = contact.along, modulus = contact.modulus;
  const double k = std::pow(contact.across / R, 0.64);
  const double thickness = 2.69 * R * std::pow(oil.viscosity / (modulus * R), 0.67) *
                           std::pow(oil.pressure_viscosity * modulus, 0.53) *
                           std::pow(modulus * R * R, kFilmFalls) * (1 - 0.61 * std::exp(-0.73 * k));
  oil.radius = R;
  PointFilm film;
  film.on = true;
  film.shears = shears;
  film.layer = layer;
  film.log_film = std::log2(thickness);
  film.log_approach = std::log2(std::pow(contact.stiffness, -2.0 / 3));
  film.area = contact.area;
  film.inlet = 2.849 * oil.viscosity * face * std::sqrt(R);
  film.oil = oil;
  return film;
}

}  // namespace cagetol
