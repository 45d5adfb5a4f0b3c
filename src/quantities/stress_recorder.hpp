// Stress and fatigue of a flexible cage.
#pragma once

#include "src/quantities/bar_peaks.hpp"
#include "src/quantities/cage_fatigue.hpp"
#include "src/quantities/cage_stress.hpp"
#include "src/quantities/outcome.hpp"
#include "src/quantities/turning.hpp"

namespace cagetol {

class StressRecorder {
 public:
  StressRecorder(const BearingModel& model, const CageModel& cage);

  void record(const ObservedState& at);
  void end_revolution();
  void write(QuantityValues& q) const;
  const CagePeak& peak() const { return peak_; }  ///< state of the largest stress

 private:
  const BearingModel& model_;
  CageStress stress_;
  CageFatigue fatigue_;
  BarPeaks bar_peaks_;
  Series series_;
  double interval_;  ///< of the record [s]
  double last_ = 0, next_ = 0;
  bool started_ = false;
  CagePeak peak_;
};

}  // namespace cagetol
