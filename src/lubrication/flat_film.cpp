#include "src/lubrication/flat_film.hpp"

#include <numbers>
#include <stdexcept>

namespace cagetol {

FlatFilm make_flat_film(double viscosity, double area, double layer, double minimum, int points,
                        bool squeeze) {
  if (!(viscosity > 0 && layer > 0 && minimum > 0 && area >= 0 && points > 0))
    throw std::domain_error("flat film: viscosity, layer and roughness must be positive");
  const double k = squeeze ? 1.5 * viscosity * area * area / std::numbers::pi : 0;
  return {true, k / points, viscosity * area / points, 0, layer, minimum};
}

FlatFilm with_wedge(FlatFilm film, double viscosity, double width, int points) {
  film.wedge = 3.0 / 16.0 * viscosity * width * width * width / points;
  film.shear *= std::numbers::ln2;
  return film;
}

}  // namespace cagetol
