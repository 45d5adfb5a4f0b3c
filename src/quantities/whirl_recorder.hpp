// Motion of the cage's centre and axis in the window.
#pragma once

#include <optional>

#include "src/quantities/cage_whirl.hpp"
#include "src/quantities/centre_path.hpp"
#include "src/quantities/turning.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {

class WhirlRecorder {
 public:
  explicit WhirlRecorder(const BearingModel& model)
      : model_(model), whirl_(model.guide_clearance) {}
  /// Follows the centre's path in a window of enough turns of the cage.
  void follow(const WindowTimes& times);

  void record(const ObservedState& at);
  void end_revolution() { whirl_.end_revolution(); }
  /// `duration` of the window [s].
  void write(const Turning& turning, double duration, QuantityValues& q) const;
  double turned() const { return turned_; }  ///< by the centre, about the middle [rad]

 private:
  void write_path(const Turning& turning, QuantityValues& q) const;
  const BearingModel& model_;
  StepSeries radius_{kPeak | kQuantiles}, axial_, lean_y_, lean_z_;
  CageWhirl whirl_;
  std::optional<CentrePath> path_;
  double clearance_ = 0;  ///< that confines the cage [m]
  bool started_ = false;
  double turned_ = 0, angle_ = 0;
};

}  // namespace cagetol
