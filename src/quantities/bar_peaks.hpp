// Instants at which the force on a face of a bar is the largest so far in a revolution of the cage:
// there the stress beside it is read. Impacts last tens of microseconds, less than the interval at
// which the stress of the whole cage is read otherwise.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace cagetol {

class BarPeaks {
 public:
  /// `bar_stations` per face.
  BarPeaks(long bar_stations, long modes) : stations_(bar_stations) {
    before_.modes.setZero(modes);
    peak_.modes.setZero(modes);
  }

  struct State {
    Eigen::VectorXd modes, bar_force;  ///< `bar_force` as in Observation [N]
    double spin = 0;                   ///< of the centrifugal load [rad/s]
  };
  /// Follows an accepted state. True if a force that was the largest of its face in this revolution
  /// falls now: it peaked at the state before, peak().
  bool pass(const double* modes, const Eigen::VectorXd& bar_force, double spin);
  const State& peak() const { return peak_; }
  void begin_revolution();

 private:
  long stations_;
  std::vector<double> force_, largest_;  ///< of each face: last, and in this revolution [N]
  bool rose_ = false;                    ///< whether one was the largest at the last state
  State before_, peak_;                  ///< `before_`: the last state, if one was
};

}  // namespace cagetol
