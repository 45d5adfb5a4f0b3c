// The cage's part of the Newton matrix's border where nothing touches the cage: ring and cage have
// nothing to do with each other, and the cage's modes only with its spin.
#pragma once

#include <Eigen/Core>

#include "src/newton/linearisation.hpp"
#include "src/numerics/small_inverse.hpp"

namespace cagetol {

class FreeCage {
 public:
  explicit FreeCage(const StateLayout& layout);

  /// Factors for `beta` > 0 [s]; `mass` of each border direction. False where a pivot vanished or
  /// is not a number. No allocation.
  bool factor(const Linearisation& linear, const Eigen::VectorXd& mass, double beta);

  /// Solves for the cage's entries of x, both vectors over the border. Changes those of rhs.
  void solve(Eigen::VectorXd& rhs, Eigen::VectorXd& x) const;

 private:
  int count_;            ///< modes
  double spin_ = 0;      ///< what a moment about its axis gives the cage, ...
  double to_axis_[2]{};  ///< ... and the moments of this spin on its axis A_y, A_z
  double axis_[2]{};     ///< of their inverse, (a, -b; b, a): a and b
  double place_ = 0;     ///< what a force gives
  SmallInverse modes_;
  Eigen::VectorXd to_spin_, from_spin_;  ///< of the modes; the latter solved for
};

}  // namespace cagetol
