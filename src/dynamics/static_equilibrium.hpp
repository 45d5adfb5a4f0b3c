// Quasi-static equilibrium of inner ring and rollers for given roller angles: Newton on the race
// forces, centrifugal force and weight, without friction. The rollers' radial places and tilts are
// condensed onto the ring's two displacements, and its two slopes where its tilt is free. Orbiting,
// the rollers follow the races as they go round, and the normal law's damping on the way in and out
// of the load zone is part of the balance (at 10 kN and the impact law of Xin et al. it carries a
// tenth of the load sideways); at rest it is plain statics.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/dynamics/observation.hpp"

namespace cagetol {

struct StaticState {
  double ring_y = 0, ring_z = 0;     ///< displacement of the inner ring [m]
  double tilt_y = 0, tilt_z = 0;     ///< slopes of its centre line [rad]
  double ring_elastic_z = 0;         ///< elastic part of the force on the ring along z [N]
  std::vector<double> radius, tilt;  ///< of each roller (padded) [m], [rad]
  std::vector<double> inner_force;   ///< on the inner race, all slices [N]
  bool converged = false;
  int iterations = 0;
};

/// Solves from a guess and keeps it warm for the next call.
enum class RollerMotion { at_rest, orbiting };

class StaticEquilibrium {
 public:
  /// Solves the balance of the ring to a share `accuracy` of the load.
  explicit StaticEquilibrium(const BearingModel& model, double accuracy = 1e-10);

  /// `angle` has one element per roller (padded) [rad]; `orbit_rate` makes the centrifugal force
  /// [rad/s].
  const StaticState& solve(const double* angle, double orbit_rate, const RingLoad& load,
                           RollerMotion motion = RollerMotion::at_rest);
  /// The last solution.
  const StaticState& state() const { return state_; }

 private:
  /// On the ring from the rollers in equilibrium: force in y, z and, where its tilt is free,
  /// moment; derivatives with respect to displacement and tilt.
  struct RingForce {
    Eigen::Vector4d force = Eigen::Vector4d::Zero();
    Eigen::Matrix4d slope = Eigen::Matrix4d::Zero();
    double elastic_z = 0;  ///< elastic part of the force along z
    bool settled = true;   ///< every roller found its place
  };
  /// solve(), `near`: from a solution nearby.
  const StaticState& balance(const double* angle, double orbit_rate, const RingLoad& load,
                             RollerMotion motion, bool near);
  template <bool tilting>
  RingForce settle_rollers(const double* angle, double orbit_rate, RollerMotion motion, bool near);

  BearingModel model_;  ///< a copy without friction, and without damping where rollers are at rest
  NormalLaw damped_;
  double accuracy_;
  Observation unused_;  ///< of contacts, which report to one
  StaticState state_;
  std::vector<double> resting_radius_, resting_tilt_;  ///< of orbiting rollers, before they orbit
};

}  // namespace cagetol
