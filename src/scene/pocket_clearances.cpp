#include "src/scene/pocket_clearances.hpp"

#include <algorithm>
#include <limits>
#include "src/scene/pocket_outline.hpp"

namespace cagetol {

PocketClearances pocket_clearances(const Scene& scene, long pocket) {
  const CageGeometry& cage = scene.cage;
  const double diameter = each(scene.roller.diameter, pocket),
               width = each(cage.pocket_width, pocket);
  const double pitch = pitch_radius(scene.bearing);
  const PocketOutline outline = pocket_outline(cage, pitch, pocket);
  PocketClearances clearances;
  clearances.tangential = width - diameter;
  clearances.axial = each(cage.pocket_length, pocket) - scene.roller.length;
  clearances.flange = scene.bearing.flange_clearance;
  for (const int end : {0, 1})
    clearances.radial[end] = radial_play(outline, pitch, diameter / 2, end);
  clearances.by_diameters[0] = (cage.inner_diameter - inner_land_diameter(scene.bearing)) / 2;
  clearances.by_diameters[1] = (outer_land_diameter(scene.bearing) - cage.outer_diameter) / 2;
  for (const int ring : {0, 1}) clearances.ring[ring] = clearances.by_diameters[ring];
  if (cage.guidance != Guidance::roller) {
    double& guide = clearances.ring[cage.guidance == Guidance::inner ? 0 : 1];
    guide = given_or(cage.guide_clearance, guide);
  }
  return clearances;
}

double narrowest_tangential(const Scene& scene) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (long j = 0; j < scene.bearing.roller_count; ++j)
    narrowest =
        std::min(narrowest, each(scene.cage.pocket_width, j) - each(scene.roller.diameter, j));
  return std::max(narrowest, 0.0);
}

}  // namespace cagetol
