#include "src/contact_laws/hertz_point.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace cagetol {

HertzPoint hertz_point(double along, double across, double modulus) {
  using std::numbers::pi;
  if (!(along > 0 && across > 0 && modulus > 0))
    throw std::domain_error("no point contact: its reduced radii and modulus must be positive");
  const double ratio = std::max(along, across) / std::min(along, across),
               reduced = 1 / (1 / along + 1 / across);
  const double q = pi / 2 - 1, k = std::pow(ratio, 2 / pi), e = 1 + q / ratio,
               f = pi / 2 + q * std::log(ratio);
  const double a = std::cbrt(6 * k * k * e * reduced / (pi * modulus));
  return {along, across, modulus, pi * k * modulus * std::sqrt(2 * e * reduced / (9 * f * f * f)),
          pi * a * a / k};
}

}  // namespace cagetol
