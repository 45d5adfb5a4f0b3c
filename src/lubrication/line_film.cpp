#include "src/lubrication/line_film.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {
namespace {

/// ln(q/q*) of the steady film, from a guess: Newton's method between bounds, as the left side
/// falls with y.
double solved(double gap, double depth, double y) {
  double low = -700, high = 140;
  for (int i = 0; i < 200 && high - low > 1e-13; ++i) {
    const double e = std::exp(-0.52 * y), r = std::exp(-4 * y), a = depth * std::exp(0.9 * y);
    const double root = std::pow(e + r, 0.25), miss = root - a - gap;
    (miss > 0 ? low : high) = y;
    const double next = y + miss / (0.25 * root * (0.52 * e + 4 * r) / (e + r) + 0.9 * a);
    if (std::abs(next - y) < 1e-14) break;
    y = next > low && next < high ? next : 0.5 * (low + high);
  }
  return y;
}

FilmTable make_table() {
  FilmTable table;
  for (int k = 0; k < FilmTable::kDepths; ++k) {
    double y = 0;
    for (int i = 0; i < FilmTable::kGaps; ++i) {
      const auto at = [](int n, int count, double first, double last) {
        return first + (last - first) * n / (count - 1);
      };
      const double place = at(i, FilmTable::kGaps, FilmTable::kFirstGap, FilmTable::kLastGap);
      const double depth = at(k, FilmTable::kDepths, FilmTable::kFirstDepth, FilmTable::kLastDepth);
      y = solved(std::sinh(place) / 2, std::exp2(depth), y);
      table.load.push_back(y / std::numbers::ln2);
    }
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
