// Motion of the cage's centre and axis in the window.
#pragma once

#include "src/quantities/cage_whirl.hpp"
#include "src/quantities/turning.hpp"

namespace cagetol {

class WhirlRecorder {
 public:
  explicit WhirlRecorder(const BearingModel& model)
      : model_(model), whirl_(model.guide_clearance) {}

  void record(const ObservedState& at);
  void end_revolution() { whirl_.end_revolution(); }
  /// `duration` of the window [s].
  void write(const Turning& turning, double duration, QuantityValues& q) const;
  double turned() const { return turned_; }  ///< by the centre, about the middle [rad]

 private:
  const BearingModel& model_;
  StepSeries radius_{kPeak | kQuantiles}, speed_, axial_, lean_y_, lean_z_;
  CageWhirl whirl_;
  bool started_ = false;
  double turned_ = 0, angle_ = 0;
};

}  // namespace cagetol
