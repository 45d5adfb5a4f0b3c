// Von Mises stress of a flexible cage at its stress stations, fast enough for every accepted step.
// The stress is that of station_stress() in src/cage/table/cage_model.hpp (elastic modes plus the
// static residual of bar forces and rotation), in single precision. Cheap bounds avoid most
// evaluations: one for the largest stress, one for its change since the last evaluation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/cage/table/cage_model.hpp"

namespace cagetol {

class CageStress {
 public:
  explicit CageStress(const CageModel& model);  ///< keeps a reference to `model`

  /// Stress at all stations: row stations (6 sector + component) + station, components xx, yy, zz,
  /// xy, yz, zx [Pa]. Valid until the next call; last() stays.
  const Eigen::VectorXf& components(const double* q, const Eigen::VectorXd& bar_force, double spin);
  /// Those of the last call of components() or largest().
  const Eigen::VectorXf& components() const { return components_; }

  struct Largest {
    double stress = 0;  ///< [Pa]
    long sector = 0, station = 0;
  };
  /// Largest stress of all stations. `q`: modal coordinates; `bar_force` as in Observation [N];
  /// `spin` of the centrifugal load, 0: none [rad/s]. Relative error 1e-5.
  Largest largest(const double* q, const Eigen::VectorXd& bar_force, double spin);

  /// Upper bound of the stress at all stations [Pa]. Von Mises stress is a norm, so the stress of a
  /// sum is at most the sum of the stresses.
  double bound(const double* q, const Eigen::VectorXd& bar_force, double spin) const;

  /// The last result of largest(), and a bound of the change since then at any station [Pa].
  const Largest& last() const { return last_; }
  double change_bound(const double* q, const Eigen::VectorXd& bar_force, double spin) const;

 private:
  /// Largest stress of the last components().
  Largest largest_of_components() const;
  /// Bound of the stress from modal coordinates, bar forces and the square of the spin.
  template <class Modes, class Forces>
  double bound_of(const Modes& q, const Forces& force, double spin_squared) const;

  /// A bar force that is not zero.
  struct ActingForce {
    long pocket, place;
    float value;
  };

  const CageModel& model_;
  long stations_, sectors_, per_pocket_;
  Eigen::VectorXd mode_norm_;  ///< largest stress per unit of each mode, then of the squared spin
  /// Largest residual stress per unit force at each station of a pocket.
  Eigen::VectorXd force_norm_;
  Eigen::VectorXf q_, components_;
  Largest last_;
  Eigen::VectorXd last_q_, last_force_;  ///< arguments of the last largest(), zero before
  double last_spin_ = 0;
  std::vector<ActingForce> acting_;
};

}  // namespace cagetol
