// Place, tilt and acceleration of the inner ring, and how well the mean force on it and its mean
// place agree with statics.
#pragma once

#include <vector>

#include "src/quantities/turning.hpp"
#include "src/statics/static_equilibrium.hpp"

namespace cagetol {

class RingRecorder {
 public:
  /// The window is [begin, end] in seconds.
  RingRecorder(const BearingModel& model, double begin, double end);

  void record(const ObservedState& at);
  void write(QuantityValues& q) const;

  /// The larger of: mean force on the ring against that at rest; mean place against that at rest.
  /// `cage_speed` is its mean [rad/s].
  double consistency_error(double cage_speed) const;
  /// The part of it that statics leaves out: the ring's change of momentum over the window, and
  /// the mean force of a cage guided by the inner ring, `guide` [N].
  double consistency_resolution(double cage_speed, double guide) const;
  /// Mean force of a roller on the inner race at rest [N].
  double carried_at_rest() const { return rest_carried_.empty() ? 0 : rest_carried_.mean(); }
  /// Number of roller positions compared with statics, and how many of them have no solution.
  long positions() const { return positions_; }
  long positions_missed() const { return positions_missed_; }
  /// Largest tilt of a free ring; 0 if the tilt is prescribed [rad].
  double largest_tilt() const { return tilt_.empty() ? 0 : tilt_.peak(); }

 private:
  void compare_with_statics(const ObservedState& at);
  double mean_imposed() const;  ///< load and weight on the ring [N]
  /// The centrifugal force of one roller [N].
  double light_force(double cage_speed) const;
  double reference_force(double cage_speed) const;  ///< of consistency_error() [N]
  /// Moment on the ring that the rollers carry, not the shaft, as a couple at the roller ends [N].
  double rollers_couple(const RingLoad& load) const;

  const BearingModel& model_;
  bool over_time_;
  double begin_, end_;
  StaticEquilibrium statics_;
  std::vector<double> angles_;
  double next_comparison_, comparison_interval_;
  long positions_ = 0, positions_missed_ = 0;
  Series displacement_, rest_displacement_, rest_elastic_, rest_carried_;
  StepSeries elastic_, along_load_, tilt_y_, tilt_z_, tilt_{kPeak}, y_{kQuantiles}, z_{kQuantiles};
  StepSeries imposed_;  ///< under a duty over time: load and weight [N]
  PlaneAcceleration acceleration_;
  double end_displacement_ = 0;
  bool started_ = false;
  double last_time_ = 0, first_speed_[2] = {0, 0}, last_speed_[2] = {0, 0};  ///< y and z [m/s]
};

}  // namespace cagetol
