#include "src/quantities/window_times.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace cagetol {
namespace {

constexpr double kLongestWindow = 3;  // of a cage that skids, over its length without slip

WindowTimes times_of_duty(const Scene& scene, const Duty& duty) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN(),
                   never = std::numeric_limits<double>::infinity();
  const Phases& phases = scene.phase;
  const double period = duty.course.repeats() ? duty.course.period() : 0;
  const auto minimum = [](const NumberList& of) {
    return *std::min_element(of.values.begin(), of.values.end());
  };
  const double settle =
      given_or(scene.window.settle_time, phases.name.empty() ? period : minimum(phases.from));
  double end = settle + period;
  if (!phases.name.empty())
    end = *std::max_element(phases.to.values.begin(), phases.to.values.end());
  else if (period == 0)
    end = duty.course.rows().back().time;
  const double measure = given_or(scene.window.measure_time, end - settle);
  return {settle, measure, measure, 0, never, none, never, 0};
}

}  // namespace

double whirl_clearance(const BearingModel& model) {
  double minimum = model.guide_clearance;
  for (int j = 0; j < model.layout.rollers; ++j) {
    const RollerGroup& group = model.groups[static_cast<std::size_t>(j / kLanes)];
    minimum = std::min(minimum, group.half_width[j % kLanes] - group.radius[j % kLanes]);
  }
  return std::max(minimum, 0.0);
}

WindowTimes window_times(const Scene& scene, const BearingModel& model) {
  if (model.duty.over_time()) return times_of_duty(scene, model.duty);
  const double revolution =
      2 * std::numbers::pi / std::abs(kinematic_cage_speed(model, model.duty.speed));
  const Window& w = scene.window;
  const double settle =
      std::isnan(w.settle_time) ? w.settle_revolutions * revolution : w.settle_time;
  const bool by_turns = std::isnan(w.measure_time);
  const double measure = by_turns ? w.measure_revolutions * revolution : w.measure_time;
  return {settle,
          measure,
          by_turns ? kLongestWindow * measure : measure,
          by_turns ? w.measure_revolutions : 0,
          given_or(w.peak_revolutions, std::numeric_limits<double>::infinity()),
          given_or(w.whirl_clearance, whirl_clearance(model)),
          revolution,
          w.longest_settle_revolutions * revolution};
}

}  // namespace cagetol
