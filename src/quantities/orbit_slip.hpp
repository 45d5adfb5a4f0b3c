// Orbital rate of the rollers over whole turns of the cage, from which the orbit slip follows.
#pragma once

namespace cagetol {

/// Follows the angles of cage and rollers, and that of rolling without slip, through a window. Mean
/// rates are angles over time, without quadrature. Only whole turns of the cage count: within a
/// turn, rollers lead or trail an off-centre cage.
class OrbitSlip {
 public:
  /// State at time t [s]: angle of the cage and mean angle of all rollers about the bearing's axis,
  /// both unwrapped [rad], and kinematic speed of the cage [rad/s].
  void record(double t, double cage_angle, double roller_angle, double rolling);

  /// Mean orbital rate of the rollers over mean kinematic speed of the cage, from the first state
  /// to the end of the last whole turn of the cage (without a whole turn: to the last state).
  /// Infinite or NaN if the cage should not have turned.
  double rate_ratio() const;

 private:
  /// Angles turned since the first state [rad].
  struct Angles {
    double cage = 0, rollers = 0, rolling = 0;
  };
  bool started_ = false;
  double time_ = 0, cage_ = 0, rollers_ = 0;  ///< of the first state; time of the last one
  double rolling_ = 0;                        ///< at the last state
  Angles last_, whole_;  ///< at the last state, and at the end of the last whole turn
  double turns_ = 0;     ///< whole turns of the cage so far
};

}  // namespace cagetol
