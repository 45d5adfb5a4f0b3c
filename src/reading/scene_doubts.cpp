#include <cmath>

#include "src/reading/scene_check.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {

std::vector<std::string> scene_doubts(const Scene& scene) {
  std::vector<std::string> doubts;
  const double axes = pitch_radius(scene.bearing);
  if (is_quasi_static(scene)) return doubts;
  const PocketOutline outline = pocket_outline(scene.cage, axes, each(scene.cage.pocket_width, 0));
  const auto beside = [&](const OutlineEnd& end, double past) {
    return !outline.curved && !end.lip && past > 0;
  };
  if (beside(outline.end[0], outline.end[0].height - axes) ||
      beside(outline.end[1], axes - outline.end[1].height))
    doubts.push_back("the rollers' axes, at a radius of " + in_mm(axes) +
                     ", lie beside the flat faces of the bars (" + in_mm(outline.end[0].height) +
                     " to " + in_mm(outline.end[1].height) +
                     " above the cage's axis): rollers ride on the bars' edges, with more "
                     "clearance and inclined forces");
  return doubts;
}

}  // namespace cagetol
