// All forces of the bearing at one state: the right-hand side, and on request the derivatives and
// what a run observes. Equations, frames and signs: src/NOTATION.md.
#pragma once

#include "src/model/bearing_model.hpp"
#include "src/model/observation.hpp"
#include "src/newton/linearisation.hpp"
#include "src/numerics/kernel.hpp"

namespace cagetol {

/// dy/dt into `rate` (layout.size() each). No allocation.
CAGETOL_KERNEL void evaluate_rates(const BearingModel& model, double t, const double* y,
                                   double* rate);

/// The same, with derivatives and observation.
CAGETOL_KERNEL void linearise(const BearingModel& model, double t, const double* y, double* rate,
                              Linearisation& linear, Observation& seen);

/// Kinetic energy of all bodies but the driven spin of the inner ring, plus potential of gravity
/// and of the shaft's hold on a ring whose tilt is free [J].
CAGETOL_KERNEL double body_energy(const BearingModel& model, const double* y);

}  // namespace cagetol
