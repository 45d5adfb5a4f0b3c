// Dense factors of a small square matrix without pivoting, whole packs of a column at a time. For
// matrices whose symmetric part is positive definite: then no pivot vanishes.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/numerics/pack.hpp"

namespace cagetol {

class SmallLu {
 public:
  explicit SmallLu(int n);

  /// Factors A (n x n). False where a pivot vanishes or is not a number. No allocation.
  bool factor(const Eigen::MatrixXd& A);
  /// x = A^-1 b; x may be b. No allocation.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  int n_, packs_;
  std::vector<Pack> lower_, upper_;  ///< strict parts, column by column, zero elsewhere
  std::vector<Pack> column_;
  std::vector<double> inverse_;  ///< of the pivots
};

}  // namespace cagetol
