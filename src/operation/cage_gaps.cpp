#include "src/operation/cage_gaps.hpp"

#include <cmath>

#include "src/scene/pocket_clearances.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {

CageGaps cage_gaps(const OperatingScene& scene) {
  CageGaps gaps;
  const double pitch = pitch_radius(scene.bearing);
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const double diameter = each(scene.roller.diameter, j);
    gaps[0].push_back(each(scene.cage.pocket_width, j) - diameter);
    gaps[1].push_back(each(scene.cage.pocket_length, j) - scene.roller.length);
    const PocketOutline outline = pocket_outline(scene.cage, pitch, j);
    for (const std::size_t end : {0, 1}) {
      const OutlineEnd& lip = outline.end[end];
      if (!lip.lip) continue;
      const double reach = diameter / 2 + outline.edge_radius;
      const double way = end == 0 ? pitch - lip.height : lip.height - pitch;
      gaps[2 + end].push_back((way > 0 ? std::hypot(way, lip.offset) : way) - reach);
    }
  }
  if (is_quasi_static(scene)) return gaps;
  const PocketClearances left = pocket_clearances(scene, 0);
  for (const std::size_t ring : {0, 1}) gaps[4 + ring] = {left.ring[ring]};
  return gaps;
}

}  // namespace cagetol
