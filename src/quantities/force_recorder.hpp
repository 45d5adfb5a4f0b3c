// Forces on the cage: of rollers on bars and side ring faces, of the guiding ring on the lands.
#pragma once

#include <vector>

#include "src/quantities/turning.hpp"

namespace cagetol {

class ForceRecorder {
 public:
  explicit ForceRecorder(const BearingModel& model) : model_(model) {}

  void record(const ObservedState& at);
  /// `duration` of the window [s].
  void write(const Turning& turning, double duration, QuantityValues& q) const;
  double mean_guide_force() const { return guide_.mean(); }  ///< [N]

 private:
  /// Counts contacts that close. A contact closed in the first state is not counted.
  struct Impacts {
    std::vector<Mask> open;
    long count = 0;
    void see(std::size_t pack, Mask touching);
  };
  const BearingModel& model_;
  RollerSeries pocket_{kPeak | kQuantiles}, end_{kPeak | kQuantiles};
  StepSeries guide_{kPeak | kQuantiles};
  Impacts pocket_impacts_, end_impacts_, guide_impacts_;
};

}  // namespace cagetol
