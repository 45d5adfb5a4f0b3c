#include "src/contact_laws/hertz_line.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace cagetol {

double effective_modulus(const Material& first, const Material& second) {
  return 2 / ((1 - first.poisson * first.poisson) / first.young +
              (1 - second.poisson * second.poisson) / second.young);
}

HertzLine hertz_line(double force, double radius, double length, double modulus) {
  if (!(force >= 0 && radius > 0 && length > 0 && modulus > 0))
    throw std::domain_error("no line contact of force " + std::to_string(force) + " N, radius " +
                            std::to_string(radius) + " m, length " + std::to_string(length) +
                            " m, modulus " + std::to_string(modulus) +
                            " Pa: force must not be negative, the others positive");
  if (force == 0) return {0, 0};
  const double b = std::sqrt(8 * force * radius / (std::numbers::pi * length * modulus));
  return {b, 2 * force / (std::numbers::pi * b * length)};
}

}  // namespace cagetol
