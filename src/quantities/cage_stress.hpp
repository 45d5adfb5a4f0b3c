// Von Mises stress of a flexible cage at its stress stations, fast enough for every accepted step:
// elastic modes plus the static rest of bar forces and turning (station_stress in
// src/cage/cage_model.hpp, in single precision), and bounds that tell without looking when no
// station can exceed a known value, or has changed since one looked.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/cage_model.hpp"

namespace cagetol {

class CageStress {
 public:
  explicit CageStress(const CageModel& model);  ///< which must live as long

  struct Largest {
    double stress = 0;  ///< [Pa]
    long sector = 0, station = 0;
  };
  /// Over all stations. `q`: modal coordinates; `bar_force` as in Observation [N]; `spin` whose
  /// centrifugal load acts, 0: none [rad/s]. Relative error 1e-5.
  Largest largest(const double* q, const Eigen::VectorXd& bar_force, double spin);

  /// No station's stress exceeds this: von Mises stress is a norm, so parts add up at most [Pa].
  double bound(const double* q, const Eigen::VectorXd& bar_force, double spin) const;

  /// What largest() said last, and the most by which any station's stress can be off it now [Pa].
  const Largest& last() const { return last_; }
  double change_bound(const double* q, const Eigen::VectorXd& bar_force, double spin) const;

 private:
  /// Bound of modal coordinates, bar forces and the square of a spin.
  template <class Modes, class Forces>
  double bound_of(const Modes& q, const Forces& force, double spin_squared) const;

  /// A force that acts: its pocket, its place in the pocket.
  struct ActingForce {
    long pocket, place;
    float value;
  };

  const CageModel& model_;
  long stations_, sectors_, per_pocket_;
  Eigen::VectorXd mode_norm_;  ///< largest stress of a unit of each mode, of a unit spin
  Eigen::VectorXd
      force_norm_;  ///< largest residual stress of a unit force, by its place in a pocket
  Eigen::VectorXf q_, components_;
  Largest last_;
  Eigen::VectorXd last_q_, last_force_;  ///< of which largest() was asked, zero at first
  double last_spin_ = 0;
  std::vector<ActingForce> acting_;
};

}  // namespace cagetol
