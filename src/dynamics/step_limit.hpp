// How long the next step may be, as the contacts see it. A step that runs on into a contact, or out
// of it, gets its impulse wrong, and no error estimate that hopes for smooth motion tells: so steps
// end where a contact is about to change, or are laid around a touch so that it lies where the
// method gets its impulse right (RosenbrockTable::touch_place).
#pragma once

#include "src/numerics/pack.hpp"

namespace cagetol {

// Chosen by measurement (tests/STEP_CONTROL.md, What light touches do).
inline constexpr double kBeforeTouch = 0.1e-6;   ///< steps end so long before a touch [s], ...
inline constexpr double kBehindChange = 0.5e-6;  ///< or this long behind it
inline constexpr double kContactGrowth = 4;      ///< times the age of a contact that just closed
inline constexpr double kNearestTouch = 0.1e-6;  ///< nearer ones are laid as if so far ahead [s]
inline constexpr double kBehindTouch = 2.5e-6;   ///< steps run so far over one [s]
inline constexpr double kNoTouch = 1e30;         ///< ahead [s]

/// Length of a step that would be h long [s], laid around a touch that is due `in` [s]: one that
/// comes soon lies at `place`, in shares of the step, and the step is no longer than `span` [s];
/// before one that comes later the step ends so early that the next may be laid around it. A place
/// of 0: the method has none, the step runs over the touch.
inline double laid_around(double in, double place, double span, double h) {
  if (in >= h) return h;
  if (place == 0) return min(h, in + kBehindTouch);
  const double reach = place * min(span, h);
  return in < reach ? max(in, kNearestTouch) / place : in - reach / 2;
}

/// The shortest of all limits seen so far [s]. T: Pack, or double. Penetrations p [m] and their
/// rates p' [m/s] are positive in a contact and where it closes; `here`: lanes that exist.
template <class T>
class StepLimit {
 public:
  /// Changes farther ahead than `horizon` [s], the longest step there may be, are not looked for.
  explicit StepLimit(double horizon) : longest_(T{} + horizon) {}

  T longest() const { return longest_; }
  /// Until the next touch that a step is to be laid around [s]; very large: there is none.
  T touch_ahead() const { return touch_ahead_; }

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
  void pass(T p, T rate, M here) {
    const M ahead = here & (p < 0.0) & (rate > 0.0) & (-p < longest_ * rate);
    if (any(ahead)) lower(ahead, kBehindChange - p / rate);
  }
  /// A touch ahead that a step is to be laid around.
  template <class M>
  void lay_around(T p, T rate, M here) {
    const M ahead = here & (p < 0.0) & (rate > 0.0) & (-p < longest_ * rate);
    if (any(ahead)) touch_ahead_ = select(ahead, min(touch_ahead_, -p / rate), touch_ahead_);
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

  T longest_, touch_ahead_ = T{} + kNoTouch;
};

}  // namespace cagetol
