// The state a run starts from.
#pragma once

#include <string>
#include <vector>

#include "src/dynamics/bearing_model.hpp"

namespace cagetol {

/// "equilibrium": loaded static equilibrium, rollers in mid-pocket with the speeds of pure rolling,
/// the cage where the scene puts it, turning at its kinematic speed. "centred": ring and cage
/// centred (plus the scene's cage offset), rollers at mid-clearance.
std::vector<double> start_state(const BearingModel& model, const Start& start);

}  // namespace cagetol
