#include "src/model/race_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "src/contact_laws/hertz_line.hpp"
#include "src/contact_laws/normal_force.hpp"
#include "src/scene/materials.hpp"

namespace cagetol {

std::array<LineContact, 2> race_lines(const Scene& scene) {
  const auto& b = scene.bearing;
  double diameter = 0;
  for (long j = 0; j < b.roller_count; ++j) diameter += each(scene.roller.diameter, j);
  LineContact inner{roller_material(scene), ring_material(scene)};
  inner.radius = diameter / (2 * static_cast<double>(b.roller_count));
  LineContact outer = inner;
  inner.curvature = 2 / (b.inner_raceway_diameter - b.internal_clearance / 2);
  outer.curvature = -2 / (b.outer_raceway_diameter + b.internal_clearance / 2);
  inner.depth = (b.inner_raceway_diameter - b.bore_diameter) / 2;
  outer.depth = (b.outside_diameter - b.outer_raceway_diameter) / 2;
  return {inner, outer};
}

double reference_line_load(const Scene& scene) {
  const double rollers = static_cast<double>(scene.bearing.roller_count);
  return std::max(kSmallestLineLoad,
                  5 * largest_radial_load(scene.operation) / (rollers * scene.roller.length));
}

double race_stiffness_modulus(const Scene& scene) {
  if (scene.contact.race_approach == RaceApproach::palmgren)
    return effective_modulus(roller_material(scene), ring_material(scene));
  const double load = reference_line_load(scene), length = scene.roller.length;
  double both = 0;
  for (const LineContact& race : race_lines(scene)) {
    if (!(4 * half_width(race, load) <= std::min(race.radius, race.depth)))
      throw std::domain_error(
          "contact.race.approach = \"line\": at the load of the most loaded roller the contact is "
          "too wide for the theory; remedy: set it to \"palmgren\", or lower load.radial_N");
    both += roller_approach(race, load) + ring_approach(race, load);
  }
  const NormalLaw steel = make_normal_law({.law = ForceLaw::hertz}, length, 1);
  return kSteelModulus *
         std::pow(2 * elastic_penetration(steel, load * length) / both, steel.exponent);
}

}  // namespace cagetol
