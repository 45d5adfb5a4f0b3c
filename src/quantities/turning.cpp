#include "src/quantities/turning.hpp"

#include <numbers>
#include <numeric>

namespace cagetol {

bool Turning::has_ended(double number, double begin, double t) const {
  if (over_time_) return along_.rolled() >= 2 * std::numbers::pi * number;
  // Rounding may put the end of a revolution after the state that is meant to be there.
  return t >= begin + (number - 1e-9) * revolution_;
}

void Turning::record(const ObservedState& at, double centre) {
  const double phase = at.q[kCagePhi];
  if (!started_) start_phase_ = phase;
  started_ = true;
  revolutions_ = std::abs(phase - start_phase_) / (2 * std::numbers::pi);
  const double* angles = at.y + angle_;
  const double rollers = std::accumulate(angles, angles + rollers_, 0.0) / rollers_;
  const double apart = at.rings.inner - at.rings.outer;
  if (over_time_) {
    along_.record(at.t, at.rolling, phase, rollers, centre);
    revolutions_ = along_.travelled() / (2 * std::numbers::pi);
    cage_speed_.add(way_of_turning(at.rolling) * at.v[kCagePhi], at.step);
    rolling_.add(std::abs(at.rolling), at.step);
    between_rings_.add(std::abs(apart), at.step);
    orbit_slip_.record(at.t, along_.cage(), along_.rollers(), std::abs(at.rolling));
  } else {
    cage_speed_.add(at.v[kCagePhi], at.step);
    rolling_.add(at.rolling, at.step);
    between_rings_.add(apart, at.step);
    orbit_slip_.record(at.t, phase, rollers, at.rolling);
  }
}

void Turning::write(QuantityValues& q) const {
  q[quantity_row("cage_slip_ratio")] = turns() ? 1 - cage_speed() / rolling() : kNoValue;
  q[quantity_row("orbit_slip_ratio")] = turns() ? 1 - orbit_slip_.rate_ratio() : kNoValue;
  q[quantity_row("cage_speed_std_ratio")] =
      stands() ? kNoValue : cage_speed_.standard_deviation() / std::abs(cage_speed());
}

}  // namespace cagetol
