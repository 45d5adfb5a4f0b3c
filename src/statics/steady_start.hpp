// The steady state of a lubricated bearing, from which a run may start: the speed at which all
// torques on the cage balance over a turn, so that a bearing that skids need not find it in
// hundreds of revolutions. Each roller moves as roller_orbit.hpp says; the lands bear the mean
// force of the bars and the cage's weight, with their own torque.
//
// Several speeds may balance. The search goes down from the speed without slip, so it finds the
// state that a bearing reaches from there: the fastest stable one.
#pragma once

#include "src/statics/roller_orbit.hpp"

namespace cagetol {

/// Where the guide lands hold a cage that is pushed by a force, and how they brake it.
struct CageRest {
  double y = 0, z = 0;  ///< of its centre, from the axis of the guiding ring [m]
  double torque = 0;    ///< of both lands on the cage [N m]
};
/// Of a cage that turns at `cage_speed`, guided by one of rings at these speeds, without lean. Zero
/// where the rollers guide it.
CageRest cage_rest(const BearingModel& model, double cage_speed, const RingSpeeds& rings,
                   double force_y, double force_z);

struct SteadyStart {
  bool found = false;  ///< else `turn` has no meaning: start from the equilibrium
  OrbitTurn turn;
  CageRest rest;
  int iterations = 0;  ///< of all orbits
};

/// At speed and load of t = 0. Not found: at standstill, and where no speed balances or a roller
/// finds no periodic motion.
SteadyStart find_steady_start(const BearingModel& model);

}  // namespace cagetol
