// A bearing without inertia: equilibria of inner ring and rollers over the cage's turn, instead of
// integrated motion.
#pragma once

#include <string>

#include "src/outcome.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// The outcome of a scene whose `model.motion` is "quasi-static". Rollers stand in the middle of
/// their pockets and go round with the cage at its kinematic speed w_i R_i/(R_i + R_o), rolling
/// without slip; load and speed are the full ones, whatever the ramps. At every position the ring
/// and the rollers on the races balance load, weight, centrifugal force and the normal law's
/// damping (src/dynamics/static_equilibrium.hpp), without an oil film. Positions end with the
/// window; more than one turn repeats the first.
///
/// Defines the ring's displacements, orbit and tilt, and the tilt of spatial rollers; all other
/// quantities are NaN, slip too: it is assumed, not found. `run.steps` counts positions. Fails
/// where a position has no equilibrium.
Outcome quasi_static_outcome(const Scene& scene);

/// Whether a quasi-static run may define the quantity of that key.
bool is_quasi_static_quantity(const std::string& key);

}  // namespace cagetol
