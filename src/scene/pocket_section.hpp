// Lines of a drawing of one pocket: its bars in the radial plane, its opening seen from outside.
#pragma once

#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

/// Points of a line in a plane [m].
struct DrawnLine {
  std::vector<double> across, up;
};

/// Outline of a bar beside a pocket in the radial plane, closed: face with its edges or lips
/// (pocket_outline.hpp), outer surface, middle plane of the bar, inner surface. `side` is -1 for
/// the trailing bar, +1 for the leading one. `across`: along the tangent from the middle of the
/// pocket; `up`: along e_R from the cage's axis.
DrawnLine bar_section(const Scene& scene, long pocket, int side);

/// Opening of a pocket unrolled at the rollers' pitch radius, closed. `across`: along the tangent;
/// `up`: along the axis. Corners are rounded with `corner_radius` [m].
DrawnLine pocket_opening(const Scene& scene, long pocket, double corner_radius);

}  // namespace cagetol
