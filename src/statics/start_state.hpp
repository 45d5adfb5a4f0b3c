// The state a run starts from.
#pragma once

#include <vector>

#include "src/model/bearing_model.hpp"

namespace cagetol {

/// Angles of the rollers (padded) in the middle of their pockets, the cage turned by `cage_phase`
/// [rad].
std::vector<double> roller_angles(const BearingModel& model, double cage_phase);

/// "steady": of a lubricated bearing, its steady state (steady_start.hpp); where none is found as
/// "equilibrium". "equilibrium": loaded static equilibrium, rollers in mid-pocket with the speeds
/// of pure rolling, the cage where the scene puts it, turning at its kinematic speed. "centred":
/// ring and cage centred (plus the scene's cage offset), rollers at mid-clearance, a ring whose
/// tilt is free as its shaft would have it. "auto": "steady" where lubricated, else "equilibrium".
std::vector<double> start_state(const BearingModel& model, const Start& start);

}  // namespace cagetol
