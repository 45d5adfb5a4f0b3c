#include "src/scene/pocket_section.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/scene/pocket_outline.hpp"

namespace cagetol {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int kPoints = 25;  ///< on an arc

void add(DrawnLine& line, double across, double up) {
  line.across.push_back(across);
  line.up.push_back(up);
}

double between(double first, double last, int k) {
  return first + (last - first) * k / (kPoints - 1);
}

/// Rounding of one end of a face, from the face to the cage's surface. Angles are measured from
/// the tangent towards the surface.
DrawnLine rounding(const PocketOutline& outline, int end, double half_width, double surface) {
  const OutlineEnd& at = outline.end[end];
  const double radius = outline.edge_radius, outwards = end == 0 ? -1 : 1;
  DrawnLine line;
  double first = pi;  // a flat face
  if (outline.curved) first = pi + std::atan2(outwards * at.normal_height, at.normal_offset);
  if (at.lip) {  // its underside begins at the face
    first = 1.5 * pi;
    if (at.offset < half_width)
      add(line, half_width, at.height - outwards * radius);
    else
      first -= std::asin(std::clamp((at.offset - half_width) / radius, 0.0, 1.0));
  }
  for (int k = 0; k < kPoints; ++k) {
    const double angle = between(first, pi / 2, k);
    const double across = at.offset + radius * std::cos(angle),
                 up = at.height + outwards * radius * std::sin(angle);
    const double from_axis = std::hypot(across, up);
    if (outwards * (from_axis - surface) >= 0) {  // here it meets the surface
      add(line, across * surface / from_axis, up * surface / from_axis);
      break;
    }
    add(line, across, up);
  }
  return line;
}

void append(DrawnLine& line, const DrawnLine& more) {
  line.across.insert(line.across.end(), more.across.begin(), more.across.end());
  line.up.insert(line.up.end(), more.up.begin(), more.up.end());
}

}  // namespace

DrawnLine bar_section(const Scene& scene, long pocket, int side) {
  const CageGeometry& cage = scene.cage;
  const double width = each(cage.pocket_width, pocket);
  const PocketOutline outline = pocket_outline(cage, pitch_radius(scene.bearing), pocket);
  const double surface[2] = {cage.inner_diameter / 2, cage.outer_diameter / 2};
  DrawnLine line = rounding(outline, 0, width / 2, surface[0]);
  std::reverse(line.across.begin(), line.across.end());
  std::reverse(line.up.begin(), line.up.end());
  if (outline.curved) {
    const auto direction = [&](int end) {
      return std::atan2(outline.end[end].normal_height, outline.end[end].normal_offset);
    };
    for (int k = 0; k < kPoints; ++k) {
      const double angle = between(direction(0), direction(1), k);
      add(line, outline.face_offset + outline.face_radius * std::cos(angle),
          outline.face_height + outline.face_radius * std::sin(angle));
    }
  }
  append(line, rounding(outline, 1, width / 2, surface[1]));
  const double middle =
      pi / static_cast<double>(scene.bearing.roller_count) - side * each(cage.pocket_pitch, pocket);
  const double first[2] = {std::atan2(line.across.front(), line.up.front()),
                           std::atan2(line.across.back(), line.up.back())};
  for (const int end : {1, 0})
    for (int k = 0; k < kPoints; ++k) {
      const double angle = end == 1 ? between(first[1], middle, k) : between(middle, first[0], k);
      add(line, surface[end] * std::sin(angle), surface[end] * std::cos(angle));
    }
  for (double& across : line.across) across *= side;
  add(line, line.across.front(), line.up.front());
  return line;
}

DrawnLine pocket_opening(const Scene& scene, long pocket, double corner_radius) {
  const CageGeometry& cage = scene.cage;
  const double half_width = each(cage.pocket_width, pocket) / 2,
               half_length = each(cage.pocket_length, pocket) / 2;
  const double lean = each(cage.pocket_squareness, pocket);
  const double radius = std::clamp(corner_radius, 0.0, std::min(half_width, half_length));
  DrawnLine line;
  for (int corner = 0; corner < 4; ++corner) {
    const double across = corner == 0 || corner == 3 ? 1 : -1, up = corner < 2 ? 1 : -1;
    for (int k = 0; k < (radius > 0 ? kPoints : 1); ++k) {
      const double angle = (corner + static_cast<double>(k) / (kPoints - 1)) * pi / 2;
      const double x = up * (half_length - radius) + radius * std::sin(angle);
      add(line, across * (half_width - radius) + radius * std::cos(angle) + lean * x, x);
    }
  }
  add(line, line.across.front(), line.up.front());
  return line;
}

}  // namespace cagetol
