// How long a run settles and measures: the scene's window in seconds.
#pragma once

#include "src/dynamics/bearing_model.hpp"

namespace cagetol {

struct WindowTimes {
  double settle;          ///< before the measuring window [s]
  double measure;         ///< length of the measuring window [s]
  double longest_settle;  ///< to which settling is extended where a motion drifts [s]
};

/// Windows given in cage revolutions are taken at the kinematic cage speed.
WindowTimes window_times(const Scene& scene, const BearingModel& model);

}  // namespace cagetol
