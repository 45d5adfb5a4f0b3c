#include "src/scene/pocket_outline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cagetol {
namespace {

/// Height at which a circle of `radius` about the cage's axis passes `offset` from e_R; the axis'
/// own height where it does not reach so far.
double height_on(double radius, double offset) {
  return std::sqrt(std::max(0.0, radius * radius - offset * offset));
}

/// Centre of the rounding of a curved face's end, which touches the face and the cage's surface of
/// `surface` radius from within the bar.
void place_curved_end(const PocketOutline& outline, double surface, double inward,
                      OutlineEnd& end) {
  const double reach = outline.face_radius + outline.edge_radius;
  double offset = outline.face_offset + reach;
  for (int k = 0; k < 60; ++k) {  // each step nears it by the slopes of both curves
    end.height = height_on(surface, offset) + inward * outline.edge_radius;
    const double rise = std::clamp(end.height - outline.face_height, -reach, reach);
    offset = outline.face_offset + std::sqrt(reach * reach - rise * rise);
  }
  end.offset = offset;
  end.normal_height = (end.height - outline.face_height) / reach;
  end.normal_offset = (end.offset - outline.face_offset) / reach;
}

}  // namespace

PocketOutline pocket_outline(const CageGeometry& cage, double pitch_radius, long pocket) {
  const double pocket_width = each(cage.pocket_width, pocket);
  PocketOutline outline;
  outline.curved = !std::isnan(cage.face_radius);
  outline.edge_radius = cage.edge_radius;
  if (outline.curved) {
    outline.face_radius = cage.face_radius;
    outline.face_height = pitch_radius;
    outline.face_offset = pocket_width / 2 - cage.face_radius;
  }
  const double surface[2] = {cage.inner_diameter / 2, cage.outer_diameter / 2};
  const double retention[2] = {each(cage.retention_inner, pocket),
                               each(cage.retention_outer, pocket)};
  for (int k = 0; k < 2; ++k) {
    OutlineEnd& end = outline.end[k];
    const double inward = k == 0 ? 1 : -1;
    end.lip = !std::isnan(retention[k]);
    if (outline.curved) {
      place_curved_end(outline, surface[k], inward, end);
      continue;
    }
    const double half = (end.lip ? retention[k] : pocket_width) / 2;
    end.height = height_on(surface[k], half) + inward * outline.edge_radius;
    end.offset = half + outline.edge_radius;
  }
  return outline;
}

bool has_shaped_pockets(const CageGeometry& cage) {
  return !std::isnan(cage.face_radius) || !std::isnan(cage.retention_inner[0]) ||
         !std::isnan(cage.retention_outer[0]);
}

double radial_play(const PocketOutline& outline, double pitch_radius, double roller_radius,
                   int end) {
  const OutlineEnd& at = outline.end[end];
  const double reach = roller_radius + outline.edge_radius;
  if (at.offset >= reach) return std::numeric_limits<double>::infinity();
  const double way = end == 0 ? pitch_radius - at.height : at.height - pitch_radius;
  return way - std::sqrt(reach * reach - at.offset * at.offset);
}

double retention_width(CageGeometry cage, double pitch_radius, double roller_radius, int end,
                       double play) {
  double narrow = 0, wide = 2 * roller_radius;  // play grows with the opening
  const auto missing = [&](double width) {
    (end == 0 ? cage.retention_inner : cage.retention_outer) = {width};
    return play -
           radial_play(pocket_outline(cage, pitch_radius, 0), pitch_radius, roller_radius, end);
  };
  if (!(missing(narrow) > 0 && missing(wide) < 0)) return std::nan("");
  for (int k = 0; k < 50; ++k) {
    const double middle = (narrow + wide) / 2;
    (missing(middle) > 0 ? narrow : wide) = middle;
  }
  return wide;
}

double roller_guide_clearance(const Scene& scene, double pitch_radius) {
  double minimum = std::numeric_limits<double>::infinity();
  for (long j = 0; j < scene.bearing.roller_count; ++j) {
    const PocketOutline outline = pocket_outline(scene.cage, pitch_radius, j);
    for (const int end : {0, 1})
      minimum = std::min(
          minimum, radial_play(outline, pitch_radius, each(scene.roller.diameter, j) / 2, end));
  }
  return minimum;
}

}  // namespace cagetol
