// How far rings and cage turn in the window: revolutions, slip of the cage. Under a duty over time,
// which may reverse, speeds and angles count along rolling without slip: what turns as it should
// counts forwards, whichever way that is, and means do not cancel.
#pragma once

#include "src/quantities/observed_state.hpp"
#include "src/quantities/quantity_values.hpp"

namespace cagetol {

class Turning {
 public:
  explicit Turning(const BearingModel& model) : over_time_(model.duty.over_time()) {}

  /// `centre`: angle of the cage's centre about the middle, turned so far [rad].
  void record(const ObservedState& at, double centre);
  /// Whether the cage has ended this revolution of the window.
  bool has_ended(double number) const { return revolutions_ >= number * (1 - 1e-9); }
  void write(QuantityValues& q) const;

  bool over_time() const { return over_time_; }
  double cage_speed() const { return cage_speed_.mean(); }  ///< [rad/s]
  double rolling() const { return rolling_.mean(); }        ///< without slip [rad/s]
  bool turns() const { return rolling() != 0; }
  /// A duty over time in which nothing rolls.
  bool stands() const { return over_time_ && !turns(); }
  double between_rings() const { return between_rings_.mean(); }  ///< speed [rad/s]
  double revolutions() const { return revolutions_; }             ///< of the cage
  double centre_turned() const { return centre_turned_; }         ///< under a duty over time [rad]

 private:
  bool over_time_;
  StepSeries cage_speed_, rolling_, between_rings_;
  bool started_ = false;
  double revolutions_ = 0, centre_turned_ = 0, start_phase_ = 0;
  double last_rolling_ = 0, last_phase_ = 0, last_centre_ = 0;
};

}  // namespace cagetol
