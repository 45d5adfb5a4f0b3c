// Room between the rollers of a full complement, on the circle of their axes: neighbours that touch
// stand 2 asin((D_j + D_(j+1))/(2 D_pw)) apart around the bearing.
#pragma once

#include "src/scene/scene.hpp"

namespace cagetol {

/// Sum of all gaps, along the circle [m]; < 0: they do not fit.
double total_roller_gap(const Scene& scene);

/// Most rollers of this diameter that fit on a circle of this radius.
long most_rollers(double pitch_radius, double diameter);

}  // namespace cagetol
