// How far rings, cage and rollers turn in the window: revolutions, slip of cage and rollers.
// Under a duty over time speeds and angles count along rolling without slip (along_rolling.hpp).
#pragma once

#include <cmath>
#include <limits>

#include "src/quantities/along_rolling.hpp"
#include "src/quantities/observed_state.hpp"
#include "src/quantities/orbit_slip.hpp"
#include "src/quantities/quantity_values.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {

class Turning {
 public:
  explicit Turning(const BearingModel& model)
      : rollers_(model.layout.rollers),
        angle_(model.layout.position(kAngle, 0)),
        over_time_(model.duty.over_time()) {}
  /// Length of a revolution of the cage without slip [s].
  void set_revolution(double length) { revolution_ = length; }

  /// `centre`: angle of the cage's centre about the middle, turned so far [rad].
  void record(const ObservedState& at, double centre);
  /// Whether revolution `number` of the cage has ended, of a window that begins at `begin` [s].
  bool has_ended(double number, double begin, double t) const;
  void write(QuantityValues& q) const;

  bool over_time() const { return over_time_; }
  double cage_speed() const { return cage_speed_.mean(); }  ///< [rad/s]
  double rolling() const { return rolling_.mean(); }        ///< without slip [rad/s]
  bool turns() const { return rolling() != 0; }
  /// A duty over time in which nothing rolls.
  bool stands() const { return over_time_ && !turns(); }
  double between_rings() const { return between_rings_.mean(); }  ///< speed [rad/s]
  double revolutions() const { return revolutions_; }             ///< of the cage
  double centre_turned() const { return along_.centre(); }        ///< under a duty over time [rad]

 private:
  int rollers_, angle_;
  bool over_time_;
  double revolution_ = std::numeric_limits<double>::infinity();
  StepSeries cage_speed_, rolling_, between_rings_;
  AlongRolling along_;
  OrbitSlip orbit_slip_;
  bool started_ = false;
  double revolutions_ = 0, start_phase_ = 0;
};

}  // namespace cagetol
