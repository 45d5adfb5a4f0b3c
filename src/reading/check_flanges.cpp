#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/reading/scene_check.hpp"

namespace cagetol {
namespace {

// Spherical roller ends and inclined flanges meet at a point of both faces, between the roller's
// corner and the flange's rim.
void check_sphere_ends(const Scene& scene, const SceneCheck& check) {
  const BearingGeometry& b = scene.bearing;
  const double radius = scene.roller.end_radius, pitch = pitch_radius(b),
               most = scene.roller.diameter[0] / 2 - corner_radius(scene);
  const auto rounded = [](double value, double unit) {
    return number_text(std::round(unit_value(value, unit) * 1e3) / 1e3);
  };
  const auto degrees = [&](double height) {
    return rounded(std::asin(std::min(1.0, height / radius)), std::numbers::pi / 180);
  };
  for (const bool inner : {false, true}) {
    if ((inner ? b.inner_flanges : b.outer_flanges) == FlangeSides::none) continue;
    const char* key = inner ? "bearing.inner_flange_angle_deg" : "bearing.outer_flange_angle_deg";
    const double angle = inner ? b.inner_flange_angle : b.outer_flange_angle;
    const double rim = (inner ? b.inner_flange_diameter : b.shoulder_diameter) / 2,
                 minimum = std::abs(rim - pitch), middle = (minimum + most) / 2;
    if (radius == 0 && angle == 0) continue;
    check.require(radius > 0, key,
                  "a flat roller end meets an inclined flange at the edge of its corner only (" +
                      check.with_value("roller.end_radius_mm") + ")",
                  "give roller.end_radius_mm, " + rounded(middle / std::sin(angle), 1e-3) +
                      " for the middle of the flange, or set the angle to 0");
    check.require(angle > 0, key,
                  "a spherical-ended roller meets a plane flange at its axis, beyond the rim (" +
                      check.with_value("roller.end_radius_mm") + ")",
                  "give an angle, " + degrees(middle) +
                      " for the middle of the flange, or set roller.end_radius_mm = 0");
    const double height = radius * std::sin(angle);
    check.require(height > minimum && height < most, key,
                  "roller end and flange meet " + rounded(height, 1e-3) +
                      " mm from the roller's axis, outside the flange's face from " +
                      rounded(minimum, 1e-3) + " to " + rounded(most, 1e-3) + " mm (" +
                      check.with_value("roller.end_radius_mm") + ")",
                  "give an angle from " + degrees(minimum) + " to " + degrees(most) +
                      ", or roller.end_radius_mm from " + rounded(minimum / std::sin(angle), 1e-3) +
                      " to " + rounded(most / std::sin(angle), 1e-3));
  }
}

}  // namespace

void check_flanges(const Scene& scene, const SceneCheck& check) {
  const BearingGeometry& b = scene.bearing;
  for (const bool right : {false, true})
    check.require(has_flange(b.outer_flanges, right) || has_flange(b.inner_flanges, right),
                  "bearing.outer_flanges",
                  std::string("no flange holds the rollers on the ") +
                      (right ? "right (+x)" : "left (-x)") + " side (" +
                      check.with_value("bearing.inner_flanges") + ")",
                  "give one ring a flange there");
  check.require(b.inner_flanges == FlangeSides::none || !has_free_ring_tilt(scene),
                "model.ring_tilt",
                "flanges do not follow the free tilt of the inner ring (" +
                    check.with_value("bearing.inner_flanges") + ")",
                "set model.ring_tilt = \"prescribed\", or give the inner ring no flanges");
  for (const bool inner : {false, true}) {
    if ((inner ? b.inner_flanges : b.outer_flanges) == FlangeSides::none) continue;
    if (!has_end_film(scene)) break;
    check.require(flange_pad(scene, inner) > 0, "roller.corner_radius_mm",
                  std::string("the flanges of the ") + (inner ? "inner" : "outer") +
                      " ring do not reach past the rollers' corners (" +
                      check.with_value(inner ? "bearing.inner_flange_diameter_mm"
                                             : "bearing.shoulder_diameter_mm") +
                      ")",
                  "give a smaller corner radius, or higher flanges");
  }
  check_sphere_ends(scene, check);
  const AxialLoads loads = axial_loads(scene.operation);
  if (loads.minimum == 0 && loads.greatest == 0) return;
  const char* key = scene.operation.table.axial_load.empty() ? "load.axial_N" : "duty.axial_N";
  check.require(!is_quasi_static(scene), key,
                "rollers carry an axial load by their ends, which " +
                    check.with_value("model.motion") + " leaves out",
                "set model.motion = \"dynamic\", or leave the load out");
  for (const double load : {loads.minimum, loads.greatest})
    check.require(
        load == 0 ||
            (has_flange(b.inner_flanges, load < 0) && has_flange(b.outer_flanges, load > 0)),
        key,
        std::string("it needs a flange of the inner ring on the ") +
            (load > 0 ? "left and one of the outer ring on the right ("
                      : "right and one of the outer ring on the left (") +
            check.with_value("bearing.inner_flanges") + ", " +
            check.with_value("bearing.outer_flanges") + ")",
        "turn the load round or give the rings these flanges: an NJ has both outside and one "
        "inside, an NUP both and both");
}

}  // namespace cagetol
