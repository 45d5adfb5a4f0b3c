#include "src/window_times.hpp"

#include <cmath>
#include <numbers>

namespace cagetol {

WindowTimes window_times(const Scene& scene, const BearingModel& model) {
  const double revolution =
      2 * std::numbers::pi / std::abs(kinematic_cage_speed(model, model.inner_speed));
  const Window& w = scene.window;
  return {std::isnan(w.settle_time) ? w.settle_revolutions * revolution : w.settle_time,
          std::isnan(w.measure_time) ? w.measure_revolutions * revolution : w.measure_time,
          w.longest_settle_revolutions * revolution};
}

}  // namespace cagetol
