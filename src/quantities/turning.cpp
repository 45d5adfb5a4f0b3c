#include "src/quantities/turning.hpp"

#include <numbers>

namespace cagetol {

void Turning::record(const ObservedState& at, double centre) {
  constexpr double turn = 2 * std::numbers::pi;
  const double phase = at.q[kCagePhi], apart = at.rings.inner - at.rings.outer;
  if (!started_) start_phase_ = phase;
  if (over_time_) {
    if (started_) {
      centre_turned_ += way_of_turning(last_rolling_ + at.rolling) * (centre - last_centre_);
      revolutions_ += std::abs(phase - last_phase_) / turn;
    }
    cage_speed_.add(way_of_turning(at.rolling) * at.v[kCagePhi], at.step);
    rolling_.add(std::abs(at.rolling), at.step);
    between_rings_.add(std::abs(apart), at.step);
  } else {
    revolutions_ = std::abs(phase - start_phase_) / turn;
    cage_speed_.add(at.v[kCagePhi], at.step);
    rolling_.add(at.rolling, at.step);
    between_rings_.add(apart, at.step);
  }
  started_ = true;
  last_rolling_ = at.rolling;
  last_phase_ = phase;
  last_centre_ = centre;
}

void Turning::write(QuantityValues& q) const {
  q[quantity_row("cage_slip_ratio")] = turns() ? 1 - cage_speed() / rolling() : kNoValue;
  q[quantity_row("cage_speed_std_ratio")] =
      stands() ? kNoValue : cage_speed_.standard_deviation() / std::abs(cage_speed());
}

}  // namespace cagetol
