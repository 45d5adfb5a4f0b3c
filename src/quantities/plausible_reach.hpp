// How far parts of a bearing can move, how fast, and how hard they can press: bounds that hold
// whatever the motion, from geometry, from the speeds that are imposed and from the energy that a
// bearing can hold. They are generous by design: what lies beyond them is impossible.
#pragma once

#include "src/dynamics/bearing_model.hpp"

namespace cagetol {

/// What the bounds need to know of a run.
struct PlausibleRun {
  double begin = 0, end = 0;  ///< of the window [s]
  double revolutions = 0;     ///< of the cage within it
  double steps = 0;           ///< accepted, of the whole run; quasi-static: positions
  bool quasi_static = false;
  bool peaks_in_part = false;  ///< peaks are taken over a part of the window
};

/// Equations of motion hold for small angles of rollers, rings and cage [rad]. Parts that something
/// rights lean by some mrad, others by radians.
inline constexpr double kLeanMax = 0.1;

struct PlausibleReach {
  PlausibleReach(const Scene& scene, const BearingModel& model, const PlausibleRun& run);

  bool flexible, planar, tilts, quasi_static;
  bool peaks_in_part;
  bool turns;       ///< the inner ring never stands still within the window
  int rollers;      ///< Z
  double duration;  ///< of the window [s]
  double revolutions, steps;

  /// Largest magnitude of the inner ring's speed in the run, and smallest in the window [rad/s].
  double fastest, slowest;
  double speed;       ///< of any surface: twice that of the inner race and of a free fall [m/s]
  double orbit_rate;  ///< of a roller about the bearing's axis, at that speed [rad/s]
  double energy;  ///< that the bearing can hold: kinetic at that speed, of load and of start [J]

  double ring_move;    ///< of the inner ring from the middle: clearance and elastic approach [m]
  double whirl;        ///< of the cage's centre from the middle [m]
  double axial;        ///< of the cage from the middle [m]
  double orbit_ratio;  ///< speed of the inner ring over the kinematic cage speed
  double guide_clearance;  ///< [m]

  double pocket_force, guide_force, end_force;  ///< on one roller, on the lands, on one roller [N]
  double ring_acceleration;                     ///< [m/s^2]
  double touch_rate;                            ///< at which one contact can open and close [1/s]
  double stress;                                ///< in the cage [Pa]
  double stations;                              ///< stress stations of a sector of the cage
  double film_thickest;                         ///< [m]
  double power;                                 ///< dissipated beyond what the drive gives [W]
  double torque;                                ///< that friction on the inner race can hold [N m]
};

}  // namespace cagetol
