#include "src/quantities/observer.hpp"

#include <algorithm>
#include <numbers>

#include "src/integration/step_control.hpp"

namespace cagetol {
namespace {

constexpr double kRecordInterval = 20e-6;  // of the record that quantiles use, at most [s]
constexpr double kRecordsPerRoller = 95;   // of it between two rollers that pass, at least
constexpr double kTurnsToDrift = 2;        // of the cage: within one its speed goes up and down

/// Whether the motion should repeat itself within the window, and whether it would show.
bool should_be_stationary(const BearingModel& m, double begin, double end) {
  const double turns =
      std::abs(kinematic_cage_speed(m, m.duty.speed)) * (end - begin) / (2 * std::numbers::pi);
  return m.lubricated && !m.duty.over_time() && ramps_end(m.duty) <= begin &&
         turns >= kTurnsToDrift;
}

}  // namespace

Observer::Observer(const BearingModel& model, double begin, double end)
    : model_(model),
      begin_(begin),
      last_(begin),
      rollers_count_(model.layout.rollers),
      clock_(begin, std::min(kRecordInterval, roller_interval(model) / kRecordsPerRoller)),
      turning_(model),
      whirl_(model),
      rollers_(model),
      forces_(model),
      ring_(model, begin, end),
      power_(model) {
  if (const auto& cage = model.flexible.model) stress_.emplace(model, *cage);
  if (should_be_stationary(model, begin, end)) stationarity_.emplace(begin, end);
}

Observer::Observer(const BearingModel& model, const WindowTimes& times)
    : Observer(model, times.settle, times.settle + times.measure) {
  turns_ = times.turns;
  peak_turns_ = times.peak_turns;
  whirl_.follow(times);
}

const CagePeak& Observer::cage_peak() const {
  static const CagePeak none;
  return !stress_ ? none : extremes_.empty() ? stress_->peak() : extreme_peak_;
}

void Observer::end_revolution() {
  ++ended_revolutions_;
  whirl_.end_revolution();
  if (stress_) stress_->end_revolution();
}

void Observer::record(double t, const double* y, const System& system) {
  const ObservedState at(model_, t, y, system, clock_.advance(t));
  last_ = t;
  whirl_.record(at);
  turning_.record(at, whirl_.turned());
  rollers_.record(at);
  forces_.record(at);
  ring_.record(at);
  power_.record(at);
  if (stress_) stress_->record(at);
  if (stationarity_)
    stationarity_->record(t, {at.v[kCagePhi], at.moving, at.seen.drive_power + at.seen.load_power,
                              at.seen.friction_power + at.seen.damping_power});
  if (turning_.has_ended(static_cast<double>(ended_revolutions_ + 1))) end_revolution();
  if (turning_.has_ended(peak_turns_) && extremes_.empty()) {
    extremes_ = quantities_so_far();
    if (stress_) extreme_peak_ = stress_->peak();
  }
}

std::vector<double> Observer::quantities() const {
  std::vector<double> values = quantities_so_far();
  for (std::size_t i = 0; i < extremes_.size(); ++i)
    if (is_extreme(kQuantityRows[i].kind)) values[i] = extremes_[i];
  return values;
}

std::vector<double> Observer::quantities_so_far() const {
  const double duration = last_ - begin_;
  QuantityValues q;
  turning_.write(q);
  whirl_.write(turning_, duration, q);
  rollers_.write(turning_, q);
  forces_.write(turning_, duration, q);
  ring_.write(q);
  power_.write(turning_, duration, q);
  for (std::size_t row = 0; !stress_ && row < kQuantityRows.size(); ++row)
    if (&kQuantityRows[row].need == &need::flexible) q[row] = kNoValue;
  if (stress_) stress_->write(q);
  q[quantity_row("static_consistency_error")] = static_consistency_error();
  return q.all();
}

}  // namespace cagetol
