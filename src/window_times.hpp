// How long a run settles and measures: the scene's window in seconds.
#pragma once

#include "src/dynamics/bearing_model.hpp"

namespace cagetol {

struct WindowTimes {
  double settle;          ///< before the measuring window [s]
  double measure;         ///< length of the measuring window, at least where it ends by itself [s]
  double longest;         ///< at most [s]
  double peaks;           ///< from its beginning, over which peaks are taken [s]
  double revolution;      ///< of the cage [s], infinite at standstill
  double longest_settle;  ///< to which settling is extended where a motion drifts [s]
};

/// Cage revolutions whose means are compared before a window may end by itself, at least: of one
/// nothing tells the scatter, nor a drift.
inline constexpr double kLeastRevolutions = 2;

/// Windows given in cage revolutions are taken at the kinematic cage speed.
WindowTimes window_times(const Scene& scene, const BearingModel& model);

}  // namespace cagetol
