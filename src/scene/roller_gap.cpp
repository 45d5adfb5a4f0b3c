#include "src/scene/roller_gap.hpp"

#include <cmath>
#include <numbers>

namespace cagetol {

double total_roller_gap(const Scene& scene) {
  const double pitch = pitch_radius(scene.bearing);
  const long count = scene.bearing.roller_count;
  double taken = 0;
  for (long j = 0; j < count; ++j) {
    const double both =
        each(scene.roller.diameter, j) + each(scene.roller.diameter, j + 1 < count ? j + 1 : 0);
    taken += 2 * std::asin(both / (4 * pitch));
  }
  return (2 * std::numbers::pi - taken) * pitch;
}

long most_rollers(double pitch_radius, double diameter) {
  // Rounding must not lose the last one of rollers that just fit.
  return static_cast<long>(std::numbers::pi / std::asin(diameter / (2 * pitch_radius)) + 1e-9);
}

}  // namespace cagetol
