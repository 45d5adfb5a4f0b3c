// The inner race of the reference bearing in oil of 0.02 Pa s at 6000 rpm, one slice over the
// roller's whole length: the contact that the tables of the lubrication tests are for.
#pragma once

#include <cmath>

#include "src/lubrication/line_film.hpp"

namespace cagetol {

struct LubricatedContact {
  double viscosity = 0.02, pressure_viscosity = 1.8e-8;  ///< [Pa s], [1/Pa]
  double modulus = 2 / (2 * (1 - 0.3 * 0.3) / 208e9);    ///< [Pa]
  double radius = 3.0288e-3, length = 9e-3;              ///< [m]
  double speed = 5.8995;                                 ///< u [m/s]

  /// a of delta = a q^0.9: 77,652 L^(8/9) N/mm^(10/9).
  double approach() const {
    const double K = 77652 * std::pow(1e3 * length, 8.0 / 9) * std::pow(1e3, 10.0 / 9);
    return std::pow(length / K, 0.9);
  }
  LineFilm film(double compliance = 0) const {
    return make_line_film(viscosity, pressure_viscosity, radius, modulus, approach(), compliance);
  }
  static LubricatedContact outer() {
    LubricatedContact contact;
    contact.radius = 4.4712e-3;
    return contact;
  }
};

}  // namespace cagetol
