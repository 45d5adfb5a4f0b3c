#include "src/window_times.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cagetol {

WindowTimes window_times(const Scene& scene, const BearingModel& model) {
  const double revolution =
      2 * std::numbers::pi / std::abs(kinematic_cage_speed(model, model.duty.speed));
  const Window& w = scene.window;
  const double settle =
      std::isnan(w.settle_time) ? w.settle_revolutions * revolution : w.settle_time;
  const double longest =
      std::isnan(w.measure_time) ? w.measure_revolutions * revolution : w.measure_time;
  const double peaks =
      std::isnan(w.peak_revolutions) ? longest : std::min(w.peak_revolutions * revolution, longest);
  double measure = longest;
  if (measures_until_converged(scene))
    measure =
        std::min(std::max(kLeastRevolutions, std::ceil(w.peak_revolutions)) * revolution, longest);
  return {settle,
          measure,
          longest,
          peaks,
          revolution,
          w.extrapolate_revolutions,
          w.longest_settle_revolutions * revolution};
}

}  // namespace cagetol
