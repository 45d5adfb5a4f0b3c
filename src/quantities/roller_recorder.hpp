// Motion of the rollers and what their contacts with the inner race carry.
#pragma once

#include "src/quantities/turning.hpp"

namespace cagetol {

class RollerRecorder {
 public:
  explicit RollerRecorder(const BearingModel& model) : model_(model) {}

  void record(const ObservedState& at);
  void write(const Turning& turning, QuantityValues& q) const;
  /// Largest angle between the axes of a roller and of the bearing [rad].
  double largest_lean() const { return std::sqrt(largest_lean_squared_); }

 private:
  const BearingModel& model_;
  RollerSeries carried_, carried_orbit_;  ///< force on the inner race [N], and times orbital rate
  RollerSeries slip_loaded_, slip_all_, sliding_{kPeak}, speed_;
  RollerSeries skew_{kQuantiles}, tilt_{kQuantiles};
  // Under a duty over time.
  StepSeries spun_;                 ///< spin without slip [rad/s]
  RollerSeries spun_loaded_;        ///< likewise, of loaded rollers
  RollerSeries carried_rolling_;    ///< force times speed of the cage without slip
  double thinnest_film_ = kNoFilm;  ///< [m]
  double rubbing_ = 0;              ///< largest power of sliding [W]
  double load_ = 0, inner_slice_ = 0, outer_slice_ = 0;  ///< largest at the races [N]
  double largest_lean_squared_ = 0;
};

}  // namespace cagetol
