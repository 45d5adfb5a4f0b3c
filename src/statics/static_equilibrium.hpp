// Quasi-static equilibrium of inner ring and rollers for given roller angles: Newton on the race
// forces, centrifugal force and weight, without friction. The rollers' radial places and tilts are
// condensed onto the ring's two displacements, and its two slopes where its tilt is free. Orbiting,
// the rollers follow the races as they go round, and the normal law's damping on the way in and out
// of the load zone is part of the balance (at 10 kN and the impact law of Xin et al. it carries a
// tenth of the load sideways); at rest it is plain statics.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/model/bearing_model.hpp"

namespace cagetol {

struct StaticState {
  double ring_y = 0, ring_z = 0;     ///< displacement of the inner ring [m]
  double tilt_y = 0, tilt_z = 0;     ///< slopes of its centre line [rad]
  double ring_elastic[2] = {0, 0};   ///< elastic part of the force on the ring, y and z [N]
  std::vector<double> radius, tilt;  ///< of each roller (padded) [m], [rad]
  std::vector<double> inner_force;   ///< on the inner race, all slices [N]
  /// Largest force of a slice at each roller's races [N].
  std::vector<double> inner_slice, outer_slice;
  bool converged = false;
  int iterations = 0;
};

enum class RollerMotion { at_rest, orbiting };

/// Solves from a guess and keeps it warm for the next call.
class StaticEquilibrium {
 public:
  /// Solves the balance of the ring to a share `accuracy` of the load.
  explicit StaticEquilibrium(const BearingModel& model, double accuracy = 1e-10);

  /// `angle` has one element per roller (padded) [rad]; `orbit_rate` makes the centrifugal force
  /// [rad/s].
  const StaticState& solve(const double* angle, double orbit_rate, const RingLoad& load,
                           RollerMotion motion = RollerMotion::at_rest);
  /// From now on films are dragged in by rollers that spin so, one element per roller (padded),
  /// between rings of these speeds; without this by rollers that roll at their orbit's rate on an
  /// outer ring of the duty's last speed, or that of turn_outer().
  void spin(const double* spins, const RingSpeeds& speeds);
  void turn_outer(double speed) { speeds_.outer = speed; }
  /// From now on the rings, whose raceways may have waves, stand so.
  void turn_rings(const RingAngles& angles) { angles_ = angles; }
  /// The last solution.
  const StaticState& state() const { return state_; }

 private:
  struct RingForce;
  /// From a solution nearby: ring and rollers, at rest and orbiting, in one iteration. False where
  /// that does not lead to a solution.
  bool follow(const double* angle, double orbit_rate, const RingLoad& load);
  /// From anywhere: the ring, on rollers that have settled around each of its places.
  void balance(const double* angle, double orbit_rate, const RingLoad& load, RollerMotion motion);
  /// From nowhere, where the others led to no solution: downhill with rollers at rest, then with
  /// more and more of the damping of orbiting ones.
  void search(const double* angle, double orbit_rate, const RingLoad& load, RollerMotion motion);
  void reset();
  /// The ring on rollers at rest, to a minimum of their potential energy.
  RingForce descend(const double* angle, double orbit_rate, const RingLoad& load);
  /// Newton's iteration on orbiting rollers under `damped_`, from a solution nearby. False where it
  /// ends without one.
  bool correct(const double* angle, double orbit_rate, const RingLoad& load, RingForce& f);
  RingForce settle_rollers(const double* angle, double orbit_rate, const RingLoad& load,
                           RollerMotion motion);
  /// Load, weight and shaft on the ring.
  void add_outside(const RingLoad& load, RingForce& ring) const;
  Eigen::Vector4d newton_move(const RingForce& ring, const RingLoad& load) const;
  void move_ring(const Eigen::Vector4d& d);

  /// Load and weight: y and z [N].
  Eigen::Vector2d force(const RingLoad& load) const;
  double size(const RingLoad& load) const;           ///< of what the rollers carry [N]
  double tolerance(const RingLoad& load) const;      ///< of the imbalance [N]
  double imbalance(const RingForce& ring) const;     ///< [N]
  double length(const Eigen::Vector4d& move) const;  ///< [m]

  BearingModel model_;  ///< a copy
  NormalLaw undamped_;  ///< of its races: where rollers are at rest
  NormalLaw damped_;    ///< likewise: where they orbit
  double share_ = 1;    ///< of the damping in `damped_`
  double accuracy_;
  double lever_;  ///< makes forces of moments, and moves of tilts [m]
  bool tilts_;    ///< the ring, freely
  StaticState state_;
  const double* spins_ = nullptr;
  RingSpeeds speeds_;
  RingAngles angles_;
  std::vector<double> resting_radius_, resting_tilt_;  ///< of orbiting rollers, before they orbit
};

}  // namespace cagetol
