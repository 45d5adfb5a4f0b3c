// How a roller of a lubricated bearing goes round where it goes round steadily: the ring stands at
// its mean equilibrium, the cage turns at a given constant speed w, and every roller repeats the
// motion of the one ahead of it, a function of the angle theta alone:
//
//   0              = F_r + m r w^2 - m g sin(theta)     place r between the races
//   0              = F_t - m g cos(theta)               place x in the pocket
//   I_p w ds/dtheta = F_s                               spin s
//
// F_r, F_t, F_s forces of races and bars (lubricated_race.hpp, lubricated_pocket.hpp). The
// tangential balance says what the bars bear, and with it the side and the gap. Left out: what an
// off-centre cage does to the orbital rate (within its pocket a roller passes that by),
// misalignment, waves of the raceways, lean and scatter of rollers (all are mean ones), pocket ends
// and flanges, bending of the cage, squeeze, traction on the ring, and the time from one bar to the
// other.
#pragma once

#include <vector>

#include "src/model/bearing_model.hpp"

namespace cagetol {

/// One turn of a roller, at equal angles from theta = 0.
struct OrbitTurn {
  double cage_speed = 0;                        ///< w [rad/s]
  std::vector<double> radius, spin;             ///< r [m], s [rad/s]
  std::vector<double> offset;                   ///< x: ahead of the middle of its pocket [m]
  double ring_y = 0, ring_z = 0;                ///< mean place of the inner ring [m]
  double force_y = 0, force_z = 0, torque = 0;  ///< of all rollers on the cage, mean [N], [N m]
};

class RollerOrbit {
 public:
  /// Of a lubricated model, at its speed and load at t = 0.
  explicit RollerOrbit(const BearingModel& model);

  /// Moves turn() on to cage speed `w` from where it was. False where no periodic motion was found.
  bool solve(double w);
  const OrbitTurn& turn() const { return turn_; }
  /// Iterations so far: each computes the forces round the orbit three times.
  int iterations() const { return iterations_; }

 private:
  struct Forces;
  struct Search;
  /// Of one pack of angles; `x` is moved to where the bars bear what they must.
  Forces forces(std::size_t pack, Pack r, Pack s, Pack& x) const;
  void balance_pocket(Pack need, Pack s, Pack& x) const;
  void collect(std::size_t pack, Pack r, Pack s, Pack x, double (&on_cage)[3]) const;
  /// From rolling without slip.
  void start(const BearingModel& whole);
  void finish();

  RollerGroup roller_;  ///< a mean one
  BearingModel model_;  ///< with as many of them as there are angles
  LubricatedLine bar_;  ///< whole
  double share_;        ///< rollers for each angle
  RingLoad load_;       ///< of the ring, its weight included
  double rolling_;      ///< spin of a roller that rolls without slip [rad/s]
  RingSpeeds speeds_;
  std::vector<Pack> sine_, cosine_, r_, s_, x_;
  double ring_[2] = {0, 0}, speed_ = 0;
  OrbitTurn turn_;
  int iterations_ = 0;
};

}  // namespace cagetol
