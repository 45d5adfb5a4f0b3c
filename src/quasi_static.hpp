// Quasi-static runs: equilibria of inner ring and rollers at positions over one turn of the cage,
// without integration in time.
#pragma once

#include "src/operation/operating_scene.hpp"
#include "src/quantities/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// The outcome of a scene with model.motion = "quasi-static". The rollers are in the middle of
/// their pockets, roll without slip and orbit with the cage at its kinematic speed
///   w_c = w_i R_i/(R_i + R_o)
/// Load and speed have their full values; ramps are ignored. At every position the ring and the
/// rollers balance load, weight, centrifugal force and the damping of the normal law
/// (src/statics/static_equilibrium.hpp), without an oil film. The positions cover the window, but
/// not more than one turn, and end with it.
///
/// Defined are displacement, orbit and tilt of the ring, and the tilt of rollers. All other
/// quantities are NaN, slip included, because it is an assumption here. `run.steps` counts
/// positions. The run fails if a position has no equilibrium.
Outcome quasi_static_outcome(const OperatingScene& scene);

}  // namespace cagetol
