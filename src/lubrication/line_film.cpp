#include "src/lubrication/line_film.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

/// log2(q/q*) of the steady film, by bisection: the left side falls with y.
double solved(double gap, double depth) {
  double low = -1000, high = 200;
  for (int i = 0; i < 200; ++i) {
    const double y = 0.5 * (low + high), e = y * std::numbers::ln2;
    const double left =
        std::pow(std::exp(-0.52 * e) + std::exp(-4 * e), 0.25) - depth * std::exp(0.9 * e);
    (left > gap ? low : high) = y;
  }
  return 0.5 * (low + high);
}

FilmTable make_table() {
  FilmTable table;
  for (int k = 0; k < FilmTable::kDepths; ++k)
    for (int i = 0; i < FilmTable::kGaps; ++i) {
      const auto at = [](int n, int count, double first, double last) {
        return first + (last - first) * n / (count - 1);
      };
      const double place = at(i, FilmTable::kGaps, FilmTable::kFirstGap, FilmTable::kLastGap);
      const double depth = at(k, FilmTable::kDepths, FilmTable::kFirstDepth, FilmTable::kLastDepth);
      table.load.push_back(solved(std::sinh(place) / 2, std::exp2(depth)));
    }
  return table;
}

}  // namespace

const FilmTable& film_table() {
  static const FilmTable table = make_table();
  return table;
}

LineFilm make_line_film(double viscosity, double pressure_viscosity, double radius, double modulus,
                        double approach, double compliance) {
  for (const double x : {viscosity, pressure_viscosity, radius, modulus, approach})
    if (!(x > 0) || !std::isfinite(x))
      throw std::domain_error(
          "line film: viscosity, radius, modulus and approach must be positive");
  if (!(compliance >= 0)) throw std::domain_error("line film: a compliance must not be negative");
  LineFilm film;
  film.viscosity = viscosity;
  film.radius = radius;
  film.modulus = modulus;
  film.compliance = compliance;
  film.approach = approach;
  film.elastic = 2.65 * std::pow(pressure_viscosity, 0.54) * std::pow(viscosity, 0.70) *
                 std::pow(radius, 0.43) * std::pow(modulus, -0.03);
  film.rigid = 4.895 * viscosity * radius;
  film.log_ratio = std::log2(film.rigid / film.elastic);
  film.log_rigid = std::log2(film.rigid);
  film.log_approach = std::log2(approach);
  film.squeeze = 3 * std::numbers::sqrt2 * std::numbers::pi * viscosity * std::pow(radius, 1.5);
  return film;
}

}  // namespace cagetol
