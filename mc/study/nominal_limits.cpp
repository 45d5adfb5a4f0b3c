#include "mc/study/nominal_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "mc/study/operating_points.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/operating_point.hpp"
#include "src/quantities/quantity_labels.hpp"
#include "src/quantities/quantity_table.hpp"
#include "src/simulate.hpp"

namespace cagetol {
namespace {

constexpr int kStarts = 8;

InputError refused(const Limit& limit, const std::string& why, const std::string& remedy) {
  return {{},
          "limit.max_at_minimum_loads",
          fmt::format("{:g}", *limit.minimum_loads),
          limit.quantity + ": " + why,
          remedy};
}

/// At the limit's point, with that multiple of the minimum load there.
Scene nominal_scene(const Study& study, const Limit& limit) {
  Scene scene = study.scene;
  const std::string label = labelled_key(limit.quantity).label;
  const auto point = std::find_if(study.points.begin(), study.points.end(),
                                  [&](const OperatingPointPlan& p) { return p.name == label; });
  if (point != study.points.end()) scene = at_operating_point(scene, *point);
  scene.temperature.balance = false;  // what it found stays
  scene.cage.model = CageKind::rigid;
  scene.operation.radial_load = *limit.minimum_loads * minimum_load_of(scene);
  if (!std::isfinite(scene.operation.radial_load))
    throw refused(limit, "the scene does not give the maker's minimum load",
                  "give bearing.minimum_load_factor and bearing.reference_speed_rpm, or max");
  return scene;
}

double nominal_value(const Study& study, const Limit& limit) {
  Scene scene = nominal_scene(study, limit);
  const double phase = scene.start.cage_phase;
  const auto row = static_cast<std::size_t>(quantity_index(labelled_key(limit.quantity).key));
  double sum = 0;
  for (int start = 0; start < kStarts; ++start) {
    scene.start.cage_phase = phase + 2 * std::numbers::pi * start / kStarts;
    const Outcome outcome = simulate(scene);
    if (outcome.status != Status::ok || !std::isfinite(outcome.quantities[row]))
      throw refused(limit,
                    fmt::format("the nominal bearing has no such value at {:.4g} N: {}",
                                scene.operation.radial_load, outcome.reason),
                    "give max, or a larger multiple");
    sum += outcome.quantities[row];
  }
  return std::strtod(fmt::format("{:.3g}", sum / kStarts).c_str(), nullptr);
}

}  // namespace

void find_nominal_limits(Study& study) {
  for (Limit& limit : study.limits)
    if (limit.minimum_loads && !limit.maximum) limit.maximum = nominal_value(study, limit);
}

}  // namespace cagetol
