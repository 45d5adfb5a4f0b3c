#include "src/contact_laws/oil_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cagetol {
namespace {

/// log2 x of x - x^-m = ratio, from a guess.
double start_value(double ratio, double decay, double guess) {
  double s = guess;
  for (int i = 0; i < 60; ++i) {
    const double x = std::exp2(s), g = std::exp2(-decay * s);
    const double step = (x - g - ratio) / ((x + decay * g) * std::numbers::ln2);
    s -= std::clamp(step, -1.0, 1.0);
    if (std::abs(step) < 1e-14) break;
  }
  return s;
}

FilmStart make_start(double decay) {
  FilmStart start;
  const int nodes = static_cast<int>((FilmStart::kTo - FilmStart::kFrom) * FilmStart::kPerUnit) + 1;
  double s = std::log2(FilmStart::kTo);
  start.value.resize(static_cast<std::size_t>(nodes));
  start.slope.resize(static_cast<std::size_t>(nodes));
  for (int i = nodes - 1; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    s = start_value(FilmStart::kFrom + i / FilmStart::kPerUnit, decay, s);
    start.value[at] = s;
    start.slope[at] = 1 / ((std::exp2(s) + decay * std::exp2(-decay * s)) * std::numbers::ln2 *
                           FilmStart::kPerUnit);
  }
  return start;
}

}  // namespace

FilmLaw make_film_law(const OilFilm& film, double modulus, double radius, double length,
                      long slices, const NormalLaw& normal) {
  FilmLaw law;
  law.on = film.model != FilmModel::none;
  if (!law.on) return law;
  const double slice = length / static_cast<double>(slices);
  law.elastic = 2.65 * std::pow(film.pressure_viscosity, 0.54) *
                std::pow(film.viscosity, kFilmSpeedExponent) * std::pow(radius, 0.43) *
                std::pow(modulus, -0.03) * std::pow(slice, kFilmForceExponent);
  law.minimum_force = film.minimum_force / static_cast<double>(slices);
  law.minimum_root = std::pow(law.minimum_force, -kFilmForceExponent);
  law.minimum_depth = 1e6 * elastic_penetration(normal, law.minimum_force);
  law.decay = kFilmForceExponent * normal.exponent;
  law.softness = 1e6 * std::pow(normal.stiffness, -kFilmForceExponent);
  // h = C delta^-m with C = h(1 N) K^-0.13: d = C^(1/(1+m)), in um.
  law.depth_scale = std::pow(law.softness, 1 / (1 + law.decay));
  law.start = make_start(law.decay);
  return law;
}

}  // namespace cagetol
