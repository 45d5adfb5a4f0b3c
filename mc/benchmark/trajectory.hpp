// Where a bearing is after a short while, to compare ways to integrate before chaos parts them.
#pragma once

#include <vector>

#include "src/simulate.hpp"

namespace cagetol {

struct Trajectory {
  std::vector<double> state;  ///< at the horizon; empty where the run did not get there
  std::vector<double> scale;  ///< one unit of error of each component; huge for padding
  Outcome outcome;
  double motion_wall_s = 0;  ///< from the first state to the end: the search for the start left out
};

/// The scene, its cage and rollers turned on by k / count of a pitch at the start, for k = 0, 1,
/// ...
std::vector<Scene> starts_of(const Scene& scene, int count);

/// Follows the scene, as it is set to be integrated, from its start to `horizon` [s].
Trajectory follow(const Scene& scene, double horizon, SimulateOptions options = {});

/// Root mean square difference in units of the error scales (error_units) at the horizon; NaN where
/// one of the two did not get there.
double trajectory_error(const Trajectory& run, const Trajectory& reference);

}  // namespace cagetol
