// Slip of the rollers' orbits: how far they fall behind the kinematic cage speed, over whole turns
// of the cage.
#pragma once

namespace cagetol {

/// Follows angles of cage, rollers and inner ring through a window. A mean rate is the angle turned
/// over the time it took: no quadrature. What a part of a turn would add - rollers ahead of and
/// behind an off-centre cage - is left out.
class OrbitSlip {
 public:
  /// State at time t [s]: angle of the cage, mean angle of all rollers about the bearing's axis,
  /// both counted on through turns [rad], and speed of the inner ring [rad/s].
  void record(double t, double cage_angle, double roller_angle, double inner_speed);

  /// Mean orbital rate of the rollers over the mean speed of the inner ring, both from the first
  /// state to the end of the last whole turn of the cage, or to the last state where it made none.
  /// Infinite or not a number where the inner ring has not turned.
  double rate_ratio() const;

 private:
  /// Angles turned since the first state [rad].
  struct Angles {
    double cage = 0, rollers = 0, inner = 0;
  };
  bool started_ = false;
  double time_ = 0, cage_ = 0, rollers_ = 0;  ///< of the first state; time of the last one
  double inner_speed_ = 0;                    ///< at the last state
  Angles last_, whole_;  ///< at the last state, and at the end of the last whole turn
  double turns_ = 0;     ///< whole turns of the cage so far
};

}  // namespace cagetol
