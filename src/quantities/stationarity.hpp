// Whether a motion repeats itself from one part of a window to the next, or still drifts: the speed
// of the cage, the energy of motion, and with it the balance of power.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cagetol {

inline constexpr std::size_t kDriftBlocks = 12;  ///< equal parts of the window

/// How far the means over the blocks of a window drift from its one end to the other.
struct Drift {
  double value = 0;    ///< slope of the line through the means, times the window's length
  double scatter = 0;  ///< what chance alone makes of it: see block_drift
  /// More than chance, and more than `most`.
  bool exceeds(double most) const;
};

/// The least-squares line through `means`; its scatter is that of independent means that differ
/// from one to the next as these do, in the middle. A transient at the window's beginning, or the
/// drift itself, does not count as scatter.
Drift block_drift(const std::array<double, kDriftBlocks>& means);

/// What a motion may drift by and still be called stationary.
struct DriftBounds {
  double kinematic_speed;    ///< of the cage [rad/s]
  double cage_drift_max;     ///< change of the cage's speed over the window, over that speed
  double power_surplus_max;  ///< of the power dissipated
};

/// Means over the blocks of a window of what is seen at a run's accepted states.
class Stationarity {
 public:
  struct Seen {
    double cage_speed = 0;  ///< [rad/s]
    double energy = 0;      ///< of motion [J]
    double drive = 0;       ///< power that drive and load give [W]
    double loss = 0;        ///< power that is dissipated [W]
  };

  /// The window [s].
  Stationarity(double begin, double end)
      : begin_(begin),
        length_(end - begin),
        part_(length_ / static_cast<double>(kDriftBlocks)),
        parts_(kDriftBlocks) {}
  /// A window that grows by whole lengths `growth` [s], each of kDriftBlocks parts: a block is as
  /// many parts as the window has such lengths.
  static Stationarity growing(double begin, double growth) {
    Stationarity made(begin, begin + growth);
    made.grows_ = true;
    return made;
  }
  /// Where a window that grows ends for now [s]: no state beyond has been recorded.
  void end_at(double end) { length_ = end - begin_; }

  /// The state at time t, from the window's beginning on.
  void record(double t, const Seen& seen);

  Drift speed_drift() const;   ///< of the cage [rad/s]
  Drift energy_drift() const;  ///< [J]
  Seen mean() const;           ///< over the window
  /// Empty, or what is not stationary: numbers and bounds, for people.
  std::string find_drift(const DriftBounds& bounds) const;

 private:
  using Means = std::array<double, kDriftBlocks>;
  Means means(double Seen::*of) const;

  double begin_, length_, part_;
  bool grows_ = false;
  bool started_ = false;
  double time_ = 0;  ///< of the last state [s]
  Seen last_;
  std::vector<Seen> parts_;  ///< integrals
};

}  // namespace cagetol
