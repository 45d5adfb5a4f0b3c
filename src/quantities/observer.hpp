// Observes a run through its measuring window and computes its results: quantities of interest,
// energy account, consistency with statics. One recorder for each concern.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "src/quantities/force_recorder.hpp"
#include "src/quantities/power_recorder.hpp"
#include "src/quantities/ring_recorder.hpp"
#include "src/quantities/roller_recorder.hpp"
#include "src/quantities/stationarity.hpp"
#include "src/quantities/stress_recorder.hpp"
#include "src/quantities/turning.hpp"
#include "src/quantities/whirl_recorder.hpp"
#include "src/quantities/window_times.hpp"

namespace cagetol {

class Observer {
 public:
  /// The window is [begin, end] in seconds; one that counts turns of the cage may last longer.
  Observer(const BearingModel& model, double begin, double end);
  /// The first window that a run has after settling.
  Observer(const BearingModel& model, const WindowTimes& times);

  /// Records an accepted state inside the window. Expects system.linearise_at() at this state.
  void record(double t, const double* y, const System& system);

  /// All quantities in the order of quantity_table().
  std::vector<double> quantities() const;
  double energy_residual() const { return power_.energy_residual(begin_); }
  /// The part of energy_residual() that steps with this tolerance cannot resolve.
  double energy_resolution(double tolerance) const {
    return power_.energy_resolution(begin_, tolerance, ring_.carried_at_rest() * rollers_count_);
  }
  double static_consistency_error() const { return ring_.consistency_error(turning_.cage_speed()); }
  /// The part of static_consistency_error() that statics leaves out.
  double static_resolution() const {
    return ring_.consistency_resolution(turning_.cage_speed(), forces_.mean_guide_force());
  }
  const RingRecorder& ring() const { return ring_; }
  const RollerRecorder& rollers() const { return rollers_; }
  /// Whether the motion drifts through the window. None if this is not judged: dry bearing,
  /// standstill, ramp within the window, or less than two turns of the cage.
  const std::optional<Stationarity>& stationarity() const { return stationarity_; }
  /// Revolutions of the cage within the window.
  double cage_revolutions() const { return turning_.revolutions(); }
  /// Whether the cage has made the turns that the window measures.
  bool has_turned() const { return turning_.has_ended(turns_); }
  /// State of the largest stress; empty for a rigid cage.
  const CagePeak& cage_peak() const;

 private:
  void end_revolution();
  /// Of everything that has been recorded so far.
  std::vector<double> quantities_so_far() const;

  const BearingModel& model_;
  double begin_, last_;  ///< time of the window's beginning and of the last state [s]
  double turns_ = 0;     ///< of the cage that are measured
  double peak_turns_ = std::numeric_limits<double>::infinity();  ///< where peaks end
  int rollers_count_;
  StepClock clock_;
  Turning turning_;
  WhirlRecorder whirl_;
  RollerRecorder rollers_;
  ForceRecorder forces_;
  RingRecorder ring_;
  PowerRecorder power_;
  std::optional<StressRecorder> stress_;
  std::optional<Stationarity> stationarity_;
  long ended_revolutions_ = 0;
  std::vector<double> extremes_;  ///< quantities where peaks ended; empty: not yet
  CagePeak extreme_peak_;         ///< likewise
};

}  // namespace cagetol
