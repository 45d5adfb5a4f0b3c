// Bounds of displacements, speeds and forces of a bearing's parts that hold for any motion. They
// follow from the geometry, the imposed speeds and the energy that a bearing can store, and they
// are wide on purpose: values beyond them are impossible.
#pragma once

#include "src/model/bearing_model.hpp"

namespace cagetol {

/// Properties of a run that the bounds depend on.
struct PlausibleRun {
  double begin = 0, end = 0;  ///< of the window [s]
  double revolutions = 0;     ///< of the cage within it
  double steps = 0;           ///< accepted, of the whole run; quasi-static: positions
  bool quasi_static = false;
  bool peaks_in_part = false;  ///< peaks are taken over a part of the window
};

/// Largest angle of rollers, rings and cage for which the equations of motion hold [rad]. Supported
/// parts lean by some mrad, unsupported ones by radians.
inline constexpr double kLeanMax = 0.1;

struct PlausibleReach {
  PlausibleReach(const Scene& scene, const BearingModel& model, const PlausibleRun& run);

  bool flexible, planar, tilts, quasi_static;
  bool peaks_in_part;
  bool turns;       ///< rolling turns the cage throughout the window
  bool over_time;   ///< under a duty that may stand or reverse: then this is not known
  int rollers;      ///< Z
  double duration;  ///< of the window [s]
  double revolutions, steps;

  double fastest;  ///< largest magnitudes of the rings' speeds in the run, added up [rad/s]
  /// Smallest magnitudes in the window: of the kinematic cage speed, and of the inner ring's speed
  /// against the outer one [rad/s].
  double slowest, apart;
  double speed;       ///< of any surface: twice that of the races and free fall [m/s]
  double orbit_rate;  ///< of a roller about the bearing's axis, at that speed [rad/s]
  double energy;  ///< stored in the bearing: kinetic at that speed, of load and of the start [J]

  double ring_move;  ///< of the inner ring from the middle: clearance and elastic approach [m]
  double whirl;      ///< of the cage's centre from the middle [m]
  /// The same in a run with these peak forces on the lands and on a roller's bars [N].
  double whirl_under(double guide_force, double pocket_force) const;
  double axial;            ///< of the cage from the middle [m]
  double guide_clearance;  ///< [m]

  double pocket_force, guide_force, end_force;  ///< on one roller, on the lands, on one roller [N]
  double race_force, race_pressure;             ///< of one roller [N], [Pa]
  double ring_acceleration;                     ///< [m/s^2]
  double touch_rate;                            ///< closings of one contact [1/s]
  double stress;                                ///< in the cage [Pa]
  double yield, fatigue;                        ///< utilisations of the cage's strengths
  double stations;                              ///< stress stations of a sector of the cage
  double film_thickest, lambda_thickest;        ///< [m], over the roughness of races
  double power;                                 ///< dissipated in excess of the drive power [W]
  double torque;                                ///< of friction on the inner race [N m]

 private:
  double whirl_free_;  ///< of a cage that presses on nothing [m]
  NormalLaw guide_;    ///< of one contact with what guides the cage
  bool rollers_guide_;
};

}  // namespace cagetol
