// How long the next step may be, as the contacts see it. A step that runs on into a contact, or out
// of it, gets its impulse wrong, and no error estimate that hopes for smooth motion tells: so steps
// end where a contact is about to change.
#pragma once

#include "src/numerics/pack.hpp"

namespace cagetol {

// Chosen by measurement (tests/ACCURACY.md, What light touches do).
inline constexpr double kStepHorizon = 1e-3;     ///< changes farther ahead are not looked for [s]
inline constexpr double kBeforeTouch = 0.1e-6;   ///< steps end so long before a touch [s], ...
inline constexpr double kBehindChange = 0.5e-6;  ///< or this long behind it
inline constexpr double kContactGrowth = 4;      ///< times the age of a contact that just closed

/// The shortest of all limits seen so far [s]. T: Pack, or double. Penetrations p [m] and their
/// rates p' [m/s] are positive in a contact and where it closes; `here`: lanes that exist.
template <class T>
class StepLimit {
 public:
  T longest() const { return longest_; }

  /// A touch ahead: a step ends just before it, the next one, from there, just inside the contact.
  /// So little of the contact is in either that its sudden start does no harm; were the end of a
  /// long step inside, the step would take the force there for one that acts all along.
  template <class M>
  void touch(T p, T rate, M here) {
    const M ahead = here & (p < 0.0) & (rate > 0.0) & (-p < longest_ * rate);
    if (!any(ahead)) return;
    const T left = -p / rate;
    lower(ahead,
          select(left > kBeforeTouch + kBehindChange, left - kBeforeTouch, left + kBehindChange));
  }
  /// A touch or parting ahead that matters less, or comes too often: a step runs over it.
  template <class M>
  void pass(T p, T rate, M here, double behind = kBehindChange) {
    const M ahead = here & (p < 0.0) & (rate > 0.0) & (-p < longest_ * rate);
    if (any(ahead)) lower(ahead, behind - p / rate);
  }
  /// A contact that closes: while it is young its force grows less smoothly than later.
  template <class M>
  void grow(T p, T rate, M here) {
    const M young = here & (p > 0.0) & (rate > 0.0) & (kContactGrowth * p < longest_ * rate);
    if (any(young)) lower(young, max(kContactGrowth * p / rate, T{} + kBehindChange));
  }
  template <class M>
  void at_most(double time, M here) {
    lower(here, T{} + time);
  }

 private:
  template <class M>
  void lower(M here, T limit) {
    longest_ = select(here, min(longest_, limit), longest_);
  }

  T longest_ = T{} + kStepHorizon;
};

}  // namespace cagetol
