#include "src/operation/thick_ring.hpp"

#include <cmath>
#include <stdexcept>

namespace cagetol {

double pressed_growth(const ThickRing& ring, double inside, double outside, double radius) {
  const auto& [young, nu, density] = ring.material;
  const double a2 = ring.inner_radius * ring.inner_radius;
  const double share = a2 / (ring.outer_radius * ring.outer_radius);  // 0 of a large body
  return ((1 - nu) * (inside * share - outside) * radius +
          (1 + nu) * (inside - outside) * a2 / radius) /
         (young * (1 - share));
}

double spinning_growth(const ThickRing& ring, double speed, double radius) {
  if (speed == 0) return 0;
  if (!std::isfinite(ring.outer_radius))
    throw std::domain_error("thick ring: a body without end cannot rotate");
  const auto& [young, nu, density] = ring.material;
  const double a2 = ring.inner_radius * ring.inner_radius,
               b2 = ring.outer_radius * ring.outer_radius, r2 = radius * radius;
  return density * speed * speed * radius / (8 * young) *
         ((3 + nu) * (1 - nu) * (a2 + b2) + (3 + nu) * (1 + nu) * a2 * b2 / r2 -
          (1 - nu * nu) * r2);
}

}  // namespace cagetol
