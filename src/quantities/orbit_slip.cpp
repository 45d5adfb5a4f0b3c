#include "src/quantities/orbit_slip.hpp"

#include <cmath>
#include <numbers>

namespace cagetol {

void OrbitSlip::record(double t, double cage_angle, double roller_angle, double rolling) {
  if (!started_) {
    started_ = true;
    time_ = t, cage_ = cage_angle, rollers_ = roller_angle, rolling_ = rolling;
    return;
  }
  const Angles before = last_;
  last_ = {cage_angle - cage_, roller_angle - rollers_,
           before.rolling + (t - time_) * (rolling_ + rolling) / 2};
  time_ = t, rolling_ = rolling;
  const double turns = std::floor(std::abs(last_.cage) / (2 * std::numbers::pi));
  if (turns <= turns_) return;
  turns_ = turns;
  // A step turns the cage by a hundredth of a radian: a straight line joins its ends well enough.
  const double missing = std::copysign(2 * std::numbers::pi * turns, last_.cage) - before.cage;
  const double share = missing / (last_.cage - before.cage);
  const auto at = [share](double first, double last) { return first + share * (last - first); };
  whole_ = {at(before.cage, last_.cage), at(before.rollers, last_.rollers),
            at(before.rolling, last_.rolling)};
}

double OrbitSlip::rate_ratio() const {
  const Angles& turned = turns_ > 0 ? whole_ : last_;
  return turned.rollers / turned.rolling;
}

}  // namespace cagetol
