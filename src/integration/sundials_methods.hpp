// CVODE and ARKODE behind the integrator's door, with our structured Newton matrix as a direct
// linear solver.
#pragma once

#include "src/integration/integrator.hpp"

namespace cagetol {

/// Variable-order BDF of CVODE, order capped by integration.max_order. Orders 3 to 5 are unstable
/// for the lightly damped pairs of unloaded rollers: the step collapses; 2 is the sound cap.
std::unique_ptr<Integrator> make_cvode_bdf(const Integration& keys, const System& system, double t0,
                                           const double* y0);

/// ARKODE of order 3: singly diagonally implicit (ESDIRK, L-stable) or explicit (ERK,
/// stability-limited).
std::unique_ptr<Integrator> make_arkode(bool implicit, const Integration& keys,
                                        const System& system, double t0, const double* y0);

}  // namespace cagetol
