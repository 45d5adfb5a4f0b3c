// How much of the path of the cage's centre is whirl: what neither rests, nor turns with the cage,
// nor follows a turning load.
#pragma once

#include <complex>
#include <vector>

namespace cagetol {

/// Parts of the path as rms amplitudes [m].
struct CentreMotion {
  double whirl = 0;      ///< at beyond 1.5 of the cage's speed, either way
  double load_line = 0;  ///< of that, so near a turning load's speed that the window parts them not
  double circling = 0;   ///< at 0.8 to 1.2 of the cage's speed, forward
  double strongest = 0;  ///< speed of the largest part of the whirl over the cage's; < 0: backward
};

/// The centre's path, evenly sampled. Fitted by least squares are a place at rest, a circle that
/// turns with the cage and one that turns with the load; whirl is in the spectrum of the rest, both
/// ways round, through a Hann window that keeps its mean square.
class CentrePath {
 public:
  /// `interval` between samples [s].
  explicit CentrePath(double interval) : interval_(interval) {}

  struct Seen {
    std::complex<double> centre;  ///< y + i z [m]
    double cage = 0;              ///< angle of the cage, unwrapped [rad]
  };
  /// A state at time t [s]; between states the path is straight.
  void record(double t, const Seen& seen);
  /// `load_speed`: of a turning load [rad/s]; 0: none turns.
  CentreMotion motion(double load_speed) const;

 private:
  double interval_, begin_ = 0, time_ = 0;
  Seen last_;
  std::vector<Seen> path_;
};

inline constexpr double kWhirlMax = 0.5;
/// What the motion is called, of parts over the clearance that confines the cage: "whirling" beyond
/// kWhirlMax whatever the load does, "not separable" beyond it with what may be a turning load's;
/// else "circling" with the cage, by unbalance or because nothing holds it, or "stable". "unknown":
/// the window is too short.
const char* whirl_class(double whirl_ratio, double load_line_ratio, double circling_ratio);

}  // namespace cagetol
