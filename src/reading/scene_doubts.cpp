#include <cmath>
#include <numbers>

#include "src/reading/scene_check.hpp"
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

}  // namespace

std::vector<std::string> scene_doubts(const Scene& scene) {
  std::vector<std::string> doubts;
  add_direction_doubts(scene.operation.table, doubts);
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
