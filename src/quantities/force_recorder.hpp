// Forces on the cage: of rollers on bars and side ring faces, of the guiding ring on the lands.
#pragma once

#include <vector>

#include "src/quantities/peak_extrapolation.hpp"
#include "src/quantities/turning.hpp"

namespace cagetol {

/// Largest values of each revolution, ended ones and the one under way; for extrapolation.
struct BlockPeaks {
  std::vector<double> ended;
  double now = 0;
  void see(double value) { now = std::max(now, value); }
  void end() {
    ended.push_back(now);
    now = 0;
  }
};

/// Rows of an extrapolated peak and its interval.
struct ExtrapolatedRows {
  std::size_t median, low, high;
};
/// Sets them from peaks in the quantity's unit over `scale`; none where `revolutions` is NaN.
void write_extrapolated(const ExtrapolatedRows& rows, const BlockPeaks& peaks, double revolutions,
                        double scale, QuantityValues& q);

class ForceRecorder {
 public:
  explicit ForceRecorder(const BearingModel& model) : model_(model) {}

  void record(const ObservedState& at);
  void end_revolution() {
    pocket_peaks_.end();
    guide_peaks_.end();
  }
  /// `duration` of the window [s]; peaks are extrapolated to `extrapolate` revolutions.
  void write(const Turning& turning, double duration, double extrapolate, QuantityValues& q) const;
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
  BlockPeaks pocket_peaks_, guide_peaks_;
  Impacts pocket_impacts_, end_impacts_, guide_impacts_;
};

}  // namespace cagetol
