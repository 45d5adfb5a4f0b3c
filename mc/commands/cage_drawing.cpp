#include "mc/commands/cage_drawing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "src/scene/pocket_clearances.hpp"
#include "src/scene/pocket_outline.hpp"
#include "src/scene/pocket_section.hpp"

namespace cagetol {
namespace {

/// In mm, to the nanometre; null where there is none.
Json mm(double length) {
  return std::isfinite(length) ? Json(std::round(1e9 * length) / 1e6) : Json();
}

Json line_json(const DrawnLine& line) {
  Json across = Json::array(), up = Json::array();
  for (std::size_t i = 0; i < line.up.size(); ++i) {
    across.push_back(mm(line.across[i]));
    up.push_back(mm(line.up[i]));
  }
  return {{"across", across}, {"up", up}};
}

Json clearance(const std::string& key, const std::string& name, double value, const char* view,
               double across, double up) {
  return {{"key", key},   {"name", name},         {"value_mm", mm(value)},
          {"view", view}, {"across", mm(across)}, {"up", mm(up)}};
}

/// Where lips or the ends of a curved face come nearest to the roller.
Json radial_clearance(const Scene& scene, const PocketClearances& clearances, long pocket,
                      int end) {
  const double pitch = pitch_radius(scene.bearing),
               roller = each(scene.roller.diameter, pocket) / 2;
  const OutlineEnd at = pocket_outline(scene.cage, pitch, pocket).end[end];
  const double away = std::hypot(at.offset, at.height - pitch);
  return clearance(end == 0 ? "radial_inner" : "radial_outer",
                   end == 0
                       ? "radial play of the roller towards the bore, until both bars hold it"
                       : "radial play of the roller towards the outside, until both bars hold it",
                   clearances.radial[end], "section", at.offset * roller / away,
                   pitch + (at.height - pitch) * roller / away);
}

Json ring_clearance(const Scene& scene, const PocketClearances& clearances, int ring) {
  const CageGeometry& cage = scene.cage;
  const bool inner = ring == 0,
             guides = cage.guidance == (inner ? Guidance::inner : Guidance::outer);
  const double drawn = clearances.by_diameters[ring];
  std::string name = inner ? "radial, cage to inner ring" : "radial, cage to outer ring";
  if (guides) name += ", which guides it";
  if (std::abs(drawn - clearances.ring[ring]) > 1e-9)
    name += fmt::format(", as given (diameters leave {:.4f} mm)", 1e3 * drawn);
  const double angle = 0.8 * std::numbers::pi / static_cast<double>(scene.bearing.roller_count),
               radius =
                   inner ? (cage.inner_diameter - drawn) / 2 : (cage.outer_diameter + drawn) / 2;
  return clearance(inner ? "ring_inner" : "ring_outer", name, clearances.ring[ring], "section",
                   radius * std::sin(angle), radius * std::cos(angle));
}

}  // namespace

Json pocket_drawing_json(const OperatingScene& scene, long pocket) {
  const CageGeometry& cage = scene.cage;
  const BearingGeometry& bearing = scene.bearing;
  const PocketClearances c = pocket_clearances(scene, pocket);
  const double pitch = pitch_radius(bearing), diameter = each(scene.roller.diameter, pocket);
  const double width = each(cage.pocket_width, pocket), length = each(cage.pocket_length, pocket),
               half_angle = std::numbers::pi / static_cast<double>(bearing.roller_count);
  Json list{clearance("tangential", "tangential, roller to both bars together", c.tangential,
                      "section", width / 2 - c.tangential / 4, pitch),
            clearance("axial", "axial, roller to both ends of the pocket together", c.axial,
                      "outside", 0, length / 2 - c.axial / 4),
            clearance("flange", "axial, roller to both flanges together", c.flange, "outside", 0,
                      -scene.roller.length / 2 - c.flange / 4)};
  for (const int end : {1, 0}) list.push_back(radial_clearance(scene, c, pocket, end));
  for (const int ring : {1, 0}) list.push_back(ring_clearance(scene, c, ring));
  return {{"scene", scene.name},
          {"pocket", pocket},
          {"clearances", list},
          {"section",
           {{"bars",
             {line_json(bar_section(scene, pocket, -1)), line_json(bar_section(scene, pocket, 1))}},
            {"pitch_radius_mm", mm(pitch)},
            {"roller_radius_mm", mm(diameter / 2)},
            {"outer_land_radius_mm", mm(outer_land_diameter(bearing) / 2)},
            {"inner_land_radius_mm", mm(inner_land_diameter(bearing) / 2)},
            {"half_angle_rad", half_angle}}},
          {"outside",
           {{"opening", line_json(pocket_opening(scene, pocket, scene.cage.corner_radius))},
            {"cage_width_mm", mm(cage.width)},
            {"half_sector_mm", mm(half_angle * pitch)},
            {"roller_length_mm", mm(scene.roller.length)},
            {"roller_diameter_mm", mm(diameter)},
            {"flange_distance_mm", mm(scene.roller.length + bearing.flange_clearance)},
            {"pocket_width_mm", mm(width)},
            {"pocket_length_mm", mm(length)},
            {"lip_inner_mm", mm(each(cage.retention_inner, pocket))},
            {"lip_outer_mm", mm(each(cage.retention_outer, pocket))},
            {"lean_rad", each(cage.pocket_squareness, pocket)}}}};
}

std::string clearances_text(const Json& drawing) {
  std::string text = fmt::format("clearances of pocket {}, its roller in the middle [mm]:\n",
                                 drawing["pocket"].get<long>());
  for (const Json& each : drawing["clearances"])
    text += fmt::format("  {:<76}{:>9}\n", each["name"].get<std::string>(),
                        each["value_mm"].is_null()
                            ? "none"
                            : fmt::format("{:.4f}", each["value_mm"].get<double>()));
  return text;
}

}  // namespace cagetol
