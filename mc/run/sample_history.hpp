// The decimated history that a sweep keeps of each sample (study key history.points): of equally
// spaced instants that end with the measuring window, as long as it is without slip, the first
// accepted state at or after each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mc/run/history_channels.hpp"
#include "mc/study/study.hpp"
#include "mc/study_file/h5.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {

/// A column of the history, as study.h5 names it: the time of the state, the channels of the
/// bearing, the spin of one roller.
struct HistoryColumn {
  std::string name;
  H5Meaning meaning;
};
const std::vector<HistoryColumn>& history_columns();

class SampleHistory {
 public:
  /// The scene must outlive this.
  SampleHistory(const HistoryPlan& plan, const Scene& scene);

  /// To be called at every accepted state, in the order of time.
  void record(const Instant& at);

  /// To be called where the measuring window begins anew: what was recorded is forgotten.
  void restart(double begin);

  /// Column by column, history.points values each, NaN from where the run ended early; empty where
  /// no instant was reached.
  std::vector<double> take() { return next_ > 0 ? std::move(values_) : std::vector<double>(); }

 private:
  double instant(std::size_t i) const;

  const Scene& scene_;
  std::size_t points_, next_ = 0;
  int roller_;
  std::optional<WindowTimes> window_;  ///< known from the first state on
  std::vector<double> values_;
};

}  // namespace cagetol
