// Whether a motion is stationary over a window or still drifts: cage speed, kinetic energy and the
// balance of power are compared between equal parts of the window.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cagetol {

inline constexpr std::size_t kDriftBlocks = 12;  ///< equal parts of the window

/// Drift of the block means from one end of the window to the other.
struct Drift {
  double value = 0;    ///< slope of a straight line through the means, times the window's length
  double scatter = 0;  ///< standard deviation of `value` due to chance, see block_drift
  /// True if the drift exceeds both `most` and chance.
  bool exceeds(double most) const;
};

/// Drift of the least-squares line through `means`. The scatter is that of independent means with
/// the median difference between neighbours that is seen here. The median keeps the drift itself
/// and a transient at the start of the window out of the scatter.
Drift block_drift(const std::array<double, kDriftBlocks>& means);

/// Largest drift of a stationary motion.
struct DriftBounds {
  double kinematic_speed;    ///< of the cage [rad/s]
  double cage_drift_max;     ///< change of cage speed over the window, over kinematic_speed
  double power_surplus_max;  ///< of the power dissipated
};

/// Block means of a window from the accepted states of a run.
class Stationarity {
 public:
  struct Seen {
    double cage_speed = 0;  ///< [rad/s]
    double energy = 0;      ///< kinetic [J]
    double drive = 0;       ///< power of drive and load [W]
    double loss = 0;        ///< dissipated power [W]
  };

  /// The window from its beginning to its expected end [s]; it may last longer.
  Stationarity(double begin, double end)
      : begin_(begin), part_((end - begin) / (kPartsOfABlock * kDriftBlocks)) {}

  /// Records the state at time t inside the window.
  void record(double t, const Seen& seen);

  Drift speed_drift() const;   ///< of the cage [rad/s]
  Drift energy_drift() const;  ///< [J]
  Seen mean() const;           ///< over the window
  /// A message with numbers and bounds if the motion is not stationary; otherwise empty.
  std::string find_drift(const DriftBounds& bounds) const;

 private:
  using Means = std::array<double, kDriftBlocks>;
  static constexpr int kPartsOfABlock = 8;  ///< in a window of the expected length
  Means means(double Seen::*of) const;
  double length() const { return time_ - begin_; }

  double begin_, part_;
  bool started_ = false;
  double time_ = 0;  ///< of the last state [s]
  Seen last_;
  std::vector<Seen> parts_;  ///< integrals
};

}  // namespace cagetol
