// Angles under a duty that may reverse, counted along the turning that rolling without slip would
// give: what turns as it should counts forwards, whichever way that is. Means over a duty that goes
// to and fro would cancel.
#pragma once

namespace cagetol {

class AlongRolling {
 public:
  /// State at time t [s]: kinematic speed of the cage [rad/s], unwrapped angles of the cage, of the
  /// rollers (mean) and of the cage's centre about the middle [rad].
  void record(double t, double rolling, double cage, double rollers, double centre);

  double rolled() const { return rolled_; }        ///< by rolling without slip [rad]
  double cage() const { return cage_; }            ///< [rad]
  double rollers() const { return rollers_; }      ///< [rad]
  double centre() const { return centre_; }        ///< [rad]
  double travelled() const { return travelled_; }  ///< by the cage, either way [rad]

 private:
  struct Seen {
    double t = 0, rolling = 0, cage = 0, rollers = 0, centre = 0;
  };
  bool started_ = false;
  Seen last_;
  double rolled_ = 0, cage_ = 0, rollers_ = 0, centre_ = 0, travelled_ = 0;
};

}  // namespace cagetol
