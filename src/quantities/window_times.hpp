// How long a run settles and measures: the scene's window in seconds.
#pragma once

#include "src/model/bearing_model.hpp"

namespace cagetol {

struct WindowTimes {
  double settle;           ///< before the measuring window [s]
  double measure;          ///< length of the measuring window of a cage that does not slip [s]
  double longest;          ///< of that of one that does: then the window ends as it is [s]
  double turns;            ///< of the cage that it measures; 0: it is given in seconds
  double peak_turns;       ///< over which peaks are taken; infinite: over the whole window
  double whirl_clearance;  ///< over which whirl is taken [m]
  double revolution;       ///< of the cage without slip, infinite at standstill [s]
  double longest_settle;   ///< limit of settling for a motion that drifts [s]
};

/// Least of the radial guide clearance and half the clearances of pockets [m]: what confines the
/// cage's centre; 0 where nothing is left.
double whirl_clearance(const BearingModel& model);

/// Of settling, cage revolutions are converted to time with the kinematic cage speed; a window
/// counts those that the cage makes. Under a duty over time
/// windows are in seconds, or follow its phases, its period or its length; no revolution is known.
WindowTimes window_times(const Scene& scene, const BearingModel& model);

}  // namespace cagetol
