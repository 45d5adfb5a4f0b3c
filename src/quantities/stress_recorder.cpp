#include "src/quantities/stress_recorder.hpp"

#include <algorithm>

#include "src/integration/step_control.hpp"

namespace cagetol {
namespace {

// Of the record that rms and quantiles use, at most [s], and so many between two rollers that pass,
// at least. Peaks and fatigue have instants of their own.
constexpr double kInterval = 200e-6, kStressesPerRoller = 9.5;
// Weight of the first instant [s]: nothing beside another's, all where the window has no other.
constexpr double kFirst = 1e-300;
constexpr double kStressAccuracy = 1e-4;  // of a stress, relative to the largest so far

}  // namespace

StressRecorder::StressRecorder(const BearingModel& model, const CageModel& cage)
    : model_(model),
      stress_(cage),
      fatigue_(cage.stress_stations, model.layout.rollers),
      bar_peaks_(cage.bar_stations, model.layout.modes),
      interval_(std::min(kInterval, roller_interval(model) / kStressesPerRoller)) {}

void StressRecorder::end_revolution() {
  fatigue_.end_revolution();
  bar_peaks_.begin_revolution();
}

void StressRecorder::record(const ObservedState& at) {
  if (!started_) last_ = at.t;
  started_ = true;
  const bool keep = at.t >= next_;
  if (keep) next_ = std::max(next_ + interval_, at.t);
  const double* modes = at.y + model_.layout.border_position(kModes);
  const auto& bar_force = at.seen.bar_force;
  const double spin = at.seen.centrifugal_spin;
  if (bar_peaks_.pass(modes, bar_force, spin)) {
    const BarPeaks::State& top = bar_peaks_.peak();
    fatigue_.add(stress_.components(top.modes.data(), top.bar_force, top.spin));
  }
  const double peak = series_.peak();
  const double change = stress_.change_bound(modes, bar_force, spin);
  const bool changed = !(change <= kStressAccuracy * peak);
  if (!keep) {
    if (!changed || stress_.last().stress + change <= peak) return;
    if (stress_.bound(modes, bar_force, spin) <= peak) return;
  }
  const CageStress::Largest largest =
      changed ? stress_.largest(modes, bar_force, spin) : stress_.last();
  if (changed) fatigue_.add(stress_.components());
  if (largest.stress > peak || peak_.modes.empty()) {
    peak_.time = at.t;
    peak_.pocket = static_cast<int>(largest.sector);
    peak_.station = static_cast<int>(largest.station);
    peak_.modes.assign(modes, modes + model_.layout.modes);
    peak_.bar_force.assign(bar_force.begin(), bar_force.end());
    peak_.spin = spin;
  }
  series_.add(largest.stress, keep ? std::max(at.t - last_, kFirst) : 0, keep);
  if (keep) last_ = at.t;
}

void StressRecorder::write(QuantityValues& q) const {
  q[quantity_row("cage_stress_peak_MPa")] = 1e-6 * series_.peak();
  q[quantity_row("cage_stress_p99_MPa")] = 1e-6 * series_.quantile(0.99);
  q[quantity_row("cage_stress_rms_MPa")] = 1e-6 * series_.rms();
  q[quantity_row("cage_stress_peak_pocket")] = peak_.pocket;
  q[quantity_row("cage_stress_peak_station")] = peak_.station;
  const CageFatigue::Place worst = fatigue_.worst(model_.cage_strength);
  q[quantity_row("cage_fatigue_utilisation")] = worst.utilisation;
  q[quantity_row("cage_fatigue_pocket")] = static_cast<double>(worst.sector);
  q[quantity_row("cage_fatigue_station")] = static_cast<double>(worst.station);
  q[quantity_row("cage_strength_utilisation")] = series_.peak() / model_.cage_strength.yield;
}

}  // namespace cagetol
