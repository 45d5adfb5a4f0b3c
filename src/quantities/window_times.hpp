// How long a run settles and measures: the scene's window in seconds.
#pragma once

#include "src/model/bearing_model.hpp"

namespace cagetol {

struct WindowTimes {
  double settle;          ///< before the measuring window [s]
  double measure;         ///< length of the measuring window [s]
  double peaks;           ///< length over which peaks are taken, from the start of the window [s]
  double revolution;      ///< of the cage, infinite at standstill [s]
  double extrapolate;     ///< revolutions to which peaks are extrapolated; NaN: to none
  double longest_settle;  ///< limit of settling for a motion that drifts [s]
};

/// Cage revolutions are converted to time with the kinematic cage speed. Under a duty over time
/// windows are in seconds, or follow its phases, its period or its length; no revolution is known.
WindowTimes window_times(const Scene& scene, const BearingModel& model);

}  // namespace cagetol
