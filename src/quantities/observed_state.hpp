// What the recorders of a run read at an accepted state inside its window.
#pragma once

#include "src/integration/system.hpp"
#include "src/quantities/series.hpp"

namespace cagetol {

struct ObservedState {
  /// Expects system.linearise_at() at this state.
  ObservedState(const BearingModel& model, double time, const double* state, const System& of,
                const SeenStep& from_the_last)
      : t(time),
        y(state),
        system(of),
        seen(of.seen),
        step(from_the_last),
        q(y + model.layout.border_position(0)),
        v(y + model.layout.border_velocity(0)),
        dv(of.rate.data() + model.layout.border_velocity(0)),
        rings(ring_speeds_at(model.duty, t)),
        rolling(kinematic_cage_speed(model, rings)),
        imposed(ring_force_at(model, t)),
        moving(body_energy(model, y)) {}

  double t;  ///< [s]
  const double* y;
  const System& system;
  const Observation& seen;
  SeenStep step;             ///< that ends here
  const double *q, *v, *dv;  ///< border: positions, velocities, accelerations
  RingSpeeds rings;          ///< [rad/s]
  double rolling;            ///< speed of the cage without slip [rad/s]
  RingLoad imposed;          ///< load and weight on the ring
  double moving;             ///< kinetic energy [J]
};

/// Sign of a speed of rolling; 0 at rest.
inline double way_of_turning(double rolling) {
  return rolling > 0 ? 1 : rolling < 0 ? -1 : 0;
}

}  // namespace cagetol
