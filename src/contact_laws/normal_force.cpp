#include "src/contact_laws/normal_force.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace cagetol {

NormalLaw make_normal_law(const ContactParameters& parameters, double length, long shares,
                          double modulus) {
  NormalLaw law;
  const double share = 1.0 / static_cast<double>(shares);
  law.hertz = parameters.law == ForceLaw::hertz;
  if (law.hertz) {
    law.exponent = 10.0 / 9.0;
    law.stiffness = 77652.0 * std::pow(length * 1e3, 8.0 / 9.0) * std::pow(1e-3, law.exponent) *
                    share * (modulus / kSteelModulus);
    law.chi = hunt_crossley_chi(parameters.restitution, parameters.restitution_speed);
  } else {
    law.exponent = parameters.exponent;
    law.stiffness = parameters.stiffness * std::pow(1e-3, law.exponent) * share;
    law.damping = parameters.damping * share;
    law.inverse_depth = 1.0 / parameters.damping_depth;
  }
  law.softening = FixedPower(law.exponent - 1);
  return law;
}

double hunt_crossley_chi(double restitution, double speed) {
  if (!(restitution > 0 && restitution <= 1))
    throw std::domain_error("restitution coefficient " + std::to_string(restitution) +
                            " is not in (0, 1]");
  if (restitution == 1) return 0;
  // u in (0, 1/e); the left side minus the right falls from 0+ to -infinity: bisection on the sign.
  double low = 0, high = 1 / restitution;
  for (int i = 0; i < 200; ++i) {
    const double u = 0.5 * (low + high), w = restitution * u;
    const double excess = (u - std::log1p(u)) - (-w - std::log1p(-w));
    (excess > 0 ? low : high) = u;
  }
  return 0.5 * (low + high) / speed;
}

double elastic_penetration(const NormalLaw& law, double force) {
  return force > 0 ? 1e-6 * std::pow(force / law.stiffness, 1 / law.exponent) : 0;
}

}  // namespace cagetol
