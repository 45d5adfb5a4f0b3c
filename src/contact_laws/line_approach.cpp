#include "src/contact_laws/line_approach.hpp"

#include <cmath>
#include <numbers>

#include "src/contact_laws/hertz_line.hpp"

namespace cagetol {
namespace {

/// (1 - nu^2)/(pi E) [1/Pa].
double softness(const Material& m) {
  return (1 - m.poisson * m.poisson) / (std::numbers::pi * m.young);
}

}  // namespace

double half_width(const LineContact& contact, double load) {
  return hertz_line(load, 1 / (1 / contact.radius + contact.curvature), 1,
                    effective_modulus(contact.roller, contact.ring))
      .half_width;
}

double roller_approach(const LineContact& contact, double load) {
  const double a = half_width(contact, load);
  return load * softness(contact.roller) * (2 * std::log(4 * contact.radius / a) - 1);
}

double ring_approach(const LineContact& contact, double load) {
  const double a = half_width(contact, load), nu = contact.ring.poisson;
  return load * softness(contact.ring) * (2 * std::log(2 * contact.depth / a) - nu / (1 - nu));
}

}  // namespace cagetol
