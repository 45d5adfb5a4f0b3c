// The bearing as a system of ordinary differential equations, with its derivatives at the current
// state and the counts of what was evaluated. Scratch of one run: not shared between runs.
#pragma once

#include "src/dynamics/forces.hpp"
#include "src/numerics/pack_vector.hpp"

namespace cagetol {

/// One unit of error of a speed [m/s]: none coarser than the speed at which friction sets in, or
/// the power that it dissipates is not known.
double speed_scale(const BearingModel& model);

struct Counts {
  long steps = 0, rejected = 0, rhs = 0, jacobians = 0, factorisations = 0;
  double smallest_step = 1e30;
  double largest_step_error = 0;  ///< of methods without error control [error scales]
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
  PackVector scale;      ///< size of one unit of error of each component: 1 um, 1 cm/s, and
                         ///< these over lever arms
  PackVector per_scale;  ///< 1/scale
  PackVector rate;       ///< at the last linearise_at
  Linearisation linear;
  Observation seen;
  Counts counts;
};

/// Error scale of each state component: lengths 1 um, speeds speed_scale, angles and rates the same
/// divided by their lever arm; padding gets 1e30.
PackVector error_scales(const BearingModel& model);

/// Root mean square of error/scale over the components that exist.
double error_norm(const System& system, const double* error);

}  // namespace cagetol
