// How steady the cage's centre is: its scatter about its own mean place, and which kind
// of orbit it runs in each revolution of the cage.
//
// The distance of the centre from the middle does not tell: a cage that rests on its guide keeps it
// at the clearance as well as one that whirls around.
#pragma once

#include <array>
#include <cstddef>

namespace cagetol {

/// Orbit of the cage's centre in one revolution of the cage, after the three kinds of cage motion
/// of Schwarz et al. 2022, Tribology Transactions, doi 10.1080/10402004.2021.1934618 (stable,
/// circling, unstable), which Machines 2022, 10, 768 has too (local, regular circular, disordered).
/// The bounds are ours.
enum class OrbitClass : std::size_t {
  resting,   ///< rms distance from its mean place below kRestingScatter of the clearance
  circling,  ///< goes round the middle by more than kCirclingTurns, in a window in which it goes
             ///< round once at least; its radius scatters by less than kCirclingScatter of its mean
  irregular  ///< all else
};
inline constexpr std::size_t kOrbitClasses = 3;
inline constexpr double kRestingScatter = 0.25, kCirclingTurns = 0.1, kCirclingScatter = 0.25;

class CageWhirl {
 public:
  struct Seen {
    double y = 0, z = 0;  ///< centre of the cage [m]
  };
  explicit CageWhirl(double clearance) : clearance_(clearance) {}

  /// An accepted state, in the order of time [s].
  void record(double t, const Seen& seen);
  void end_revolution();

  /// Rms distance of the centre from its mean place over the clearance, over all states.
  double scatter() const { return all_.scatter() / clearance_; }
  /// Shares of the complete revolutions, NaN where there is none.
  std::array<double, kOrbitClasses> shares() const;

 private:
  /// Integrals over time by the trapezium rule.
  struct Orbit {
    double duration = 0, y = 0, z = 0, square = 0, radius = 0, turned = 0;
    void add(double step, const Seen& from, const Seen& to);
    double scatter() const;         ///< rms distance from the mean place [m]
    double radius_scatter() const;  ///< standard deviation over mean of the radius
  };
  OrbitClass orbit_class() const;

  double clearance_;
  bool started_ = false;
  double time_ = 0;
  Seen last_;
  Orbit all_, revolution_;
  std::array<long, kOrbitClasses> revolutions_{};
};

}  // namespace cagetol
