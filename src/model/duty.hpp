// What is imposed on a bearing from outside, over time: the speeds of both rings, and the load on
// the inner one. A load is a force in the radial plane and along x, and a moment conjugate to the
// ring's tilt (B_y, B_z): moment_y tilts the centre line towards +y (a vector along +z), moment_z
// towards +z (a vector along -y). The shaft takes the moment where the tilt is prescribed.
//
//   load(t)  = s(t) [F d(phi_F) + P d(phi_P + psi)] + U w_i^2 d(phi_P + turned)
//   d(phi)   = (sin phi, -cos phi) in (y, z): along -z turned by phi about +x
//
// Under a duty over time F, phi_F, axial force, moments and the speeds follow a table (DutyCourse).
//
// s rises from 0 to 1 over the ramp of the load (STEP, contact_laws/step.hpp), psi turns at a speed
// of its own or with the inner ring, `turned` is the angle of the inner ring since t = 0. Left out:
// the force along the circle of an unbalance whose speed changes, U w_i'.
#pragma once

#include "src/model/duty_course.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// About +x [rad/s].
struct RingSpeeds {
  double inner = 0, outer = 0;
};

/// Turned since t = 0, about +x [rad].
struct RingAngles {
  double inner = 0, outer = 0;
};

/// On the inner ring [N], [N m].
struct RingLoad {
  double y = 0, z = 0, moment_y = 0, moment_z = 0, axial = 0;
};

struct Duty {
  RingLoad fixed;                           ///< load that keeps its direction, in full
  double load_ramp = 0;                     ///< [s]
  double rotating = 0, rotating_speed = 0;  ///< P [N], [rad/s]
  bool with_inner = false;                  ///< P turns with the inner ring
  double phase = 0;                         ///< phi_P [rad]
  double unbalance = 0;                     ///< U [kg m]
  /// At the end and at the start of the ramp; under a duty over time the fastest pair.
  RingSpeeds speed, speed_from;
  double speed_ramp = 0;  ///< [s]
  DutyCourse course;      ///< empty: nothing follows a table

  /// Whether speed or load follow a table: windows are in seconds then.
  bool over_time() const { return !course.empty(); }
  /// Whether the load turns: no instant then stands for another.
  bool load_turns() const { return rotating != 0 || unbalance != 0; }
};

/// A direction in (y, z).
struct Way {
  double y = 0, z = -1;
  double along(double of_y, double of_z) const { return y * of_y + z * of_z; }
};
/// That of a load's force; along -z where there is none.
Way way_of(const RingLoad& load);

Duty make_duty(const Operation& operation);

RingSpeeds ring_speeds_at(const Duty& duty, double t);
/// Rates of these speeds, of a corner to come [rad/s^2].
RingSpeeds ring_accelerations_at(const Duty& duty, double t);
RingAngles ring_angles_at(const Duty& duty, double t);
/// Whether speeds, or anything at all, change at time t.
bool speeds_change(const Duty& duty, double t);
bool duty_changes(const Duty& duty, double t);
/// The next instant at which a value has a corner; infinite if there is none [s].
double next_corner(const Duty& duty, double t);
RingLoad load_at(const Duty& duty, double t);
/// Time after which nothing ramps [s].
double ramps_end(const Duty& duty);
/// Load in full, with what turns where it adds most to the rest.
RingLoad heaviest_load(const Duty& duty);
/// Its force [N].
double largest_load(const Duty& duty);
/// Largest magnitudes of the speeds.
RingSpeeds fastest_speeds(const Duty& duty);

}  // namespace cagetol
