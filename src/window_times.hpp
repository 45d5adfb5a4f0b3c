// How long a run settles and measures: the scene's window in seconds.
#pragma once

#include "src/model/bearing_model.hpp"

namespace cagetol {

struct WindowTimes {
  double settle;          ///< before the measuring window [s]
  double measure;         ///< length of the measuring window [s]
  double longest_settle;  ///< limit of settling for a motion that drifts [s]
};

/// Cage revolutions are converted to time with the kinematic cage speed.
WindowTimes window_times(const Scene& scene, const BearingModel& model);

}  // namespace cagetol
