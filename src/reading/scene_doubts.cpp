#include <cmath>
#include <numbers>
#include <utility>

#include "src/reading/scene_check.hpp"
#include "src/scene/pocket_clearances.hpp"
#include "src/scene/pocket_outline.hpp"

namespace cagetol {

namespace {

/// A load's direction follows straight lines: steps of more than half a turn go the long way round.
void add_direction_doubts(const DutyTable& table, std::vector<std::string>& doubts) {
  const auto degrees = [](double angle) {
    return number_text(std::round(angle * 1.8e5 / std::numbers::pi) / 1e3);
  };
  const auto see = [&](double from, double to) {
    if (std::abs(to - from) <= std::numbers::pi * (1 + 1e-12)) return;
    doubts.push_back("duty.direction_deg goes from " + degrees(from) + " to " + degrees(to) +
                     ", more than half a turn: for the short way write " +
                     degrees(from + std::remainder(to - from, 2 * std::numbers::pi)));
  };
  const auto& direction = table.direction.values;
  for (std::size_t i = 1; i < direction.size(); ++i) see(direction[i - 1], direction[i]);
  if (!direction.empty() && table.repeat > table.time.values.back() - table.time[0] + 1e-9)
    see(direction.back(), direction.front());
}

/// Values that their own assumption excludes.
void add_range_doubts(const Scene& scene, std::vector<std::string>& doubts) {
  for (const Assumption& assumed : scene.assumptions)
    if (assumed.has_range())
      for (const double value : key_numbers(*find_key(scene_keys(), assumed.key), scene))
        if (value < assumed.low || value > assumed.high)
          doubts.push_back(assumed.key + " = " + number_text(value) +
                           " lies outside the range of its assumption, " +
                           number_text(assumed.low) + " to " + number_text(assumed.high));
}

/// Sizes far from those of bearings: in another unit, say, or of another bearing.
void add_size_doubts(const Scene& scene, std::vector<std::string>& doubts) {
  const BearingGeometry& b = scene.bearing;
  const Lubrication& oil = scene.lubrication;
  const double clearance = b.outer_raceway_diameter - b.inner_raceway_diameter -
                           2 * each(scene.roller.diameter, 0) + b.internal_clearance;
  const PocketClearances of_cage = pocket_clearances(scene, 0);
  const int guide = scene.cage.guidance == Guidance::inner ? 0 : 1;
  const double guided = of_cage.ring[guide], other = of_cage.ring[1 - guide];
  const std::pair<bool, std::string> sizes[] = {
      {clearance > 0.005 * b.outside_diameter,
       "an internal clearance of " + in_um(clearance) + ", above 0.5 % of the outside diameter"},
      {is_lubricated(scene) && (oil.race_roughness > 20e-6 || oil.pocket_roughness > 20e-6),
       "lubrication.race_roughness_um or pocket_roughness_um is above 20 um"},
      {guided > 4 * of_cage.by_diameters[guide],
       "cage.guide_clearance_mm = " + number_text(unit_value(guided, 1e-3)) +
           ": the diameters leave " + in_mm(of_cage.by_diameters[guide])},
      {scene.cage.guidance != Guidance::roller && 4 * other < guided,
       "the ring that does not guide the cage stops it first, at " + in_mm(other) + " instead of " +
           in_mm(guided) + " (cage.guidance)"},
      {scene.cage.width > b.width, "the cage is wider than the bearing, " + in_mm(b.width)}};
  for (const auto& [holds, text] : sizes)
    if (holds) doubts.push_back(text);
}

}  // namespace

std::vector<std::string> scene_doubts(const Scene& scene) {
  std::vector<std::string> doubts;
  add_direction_doubts(scene.operation.table, doubts);
  add_range_doubts(scene, doubts);
  const double axes = pitch_radius(scene.bearing);
  if (is_quasi_static(scene)) return doubts;
  add_size_doubts(scene, doubts);
  const PocketOutline outline = pocket_outline(scene.cage, axes, 0);
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
