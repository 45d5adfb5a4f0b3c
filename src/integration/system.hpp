// The bearing as a system of ordinary differential equations, with its derivatives at the current
// state and the counts of what was evaluated. Scratch of one run: not shared between runs.
#pragma once

#include <limits>

#include "src/dynamics/forces.hpp"
#include "src/numerics/pack_vector.hpp"

namespace cagetol {

/// What counts as one unit of error; the same over a whole run, whatever its duty.
struct ErrorUnits {
  double length;  ///< [m]
  double speed;   ///< [m/s]
};

/// length = D_we/7500; speed = 1e-3 of the fastest raceway surface's, at least 1 cm/s and at most
/// the speed at which friction sets in, or the power that it dissipates is not known.
ErrorUnits error_units(const BearingModel& model);

/// integration.max_step_us; where it is "auto", 50 us, and under a steady duty a fortieth of the
/// time between two rollers that pass, if that is more [s].
double largest_step(const BearingModel& model, const Integration& keys);

struct Counts {
  long steps = 0, rejected = 0, rhs = 0, jacobians = 0, factorisations = 0;
  double smallest_step = 1e30;
};

struct System {
  explicit System(const BearingModel& m);

  /// dy/dt at (t, y). False if a component is not finite.
  bool rates(double t, const double* y, double* rate);
  /// Rates, derivatives and observation at (t, y), kept in the members below. False if not finite.
  bool linearise_at(double t, const double* y);
  /// True while load or speed depend on time explicitly.
  bool driven_by_time(double t) const;
  /// How the rates change with time alone; expects linearise_at(t, y) to have been called.
  void rates_by_time(double t, const double* y, double* out);

  const BearingModel& model;
  int size;
  int components;        ///< of the state that exist, padding left out
  PackVector scale;      ///< size of one unit of error of each component
  PackVector per_scale;  ///< 1/scale
  PackVector rate;       ///< at the last linearise_at
  Linearisation linear;
  Observation seen;
  Counts counts;
  /// Attempted steps after which no more are taken.
  double step_budget = std::numeric_limits<double>::infinity();
};

/// Error scale of each state component: error_units, of angles and rates divided by their lever
/// arm; padding gets 1e30.
PackVector error_scales(const BearingModel& model);

/// Root mean square of error/scale over the components that exist.
double error_norm(const System& system, const double* error);

}  // namespace cagetol
