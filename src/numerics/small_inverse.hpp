// Inverse of a small square matrix without pivoting, whole packs of a column at a time. For
// matrices whose symmetric part is positive definite: then no pivot vanishes. A product with the
// inverse has no chain of dependent operations, which two triangles have: it pays from the second
// right-hand side on.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/numerics/pack.hpp"

namespace cagetol {

class SmallInverse {
 public:
  static constexpr int kMost = 48;  ///< largest n
  explicit SmallInverse(int n);

  /// Inverts A (n x n). False where a pivot vanishes or is not a number. No allocation.
  bool invert(const Eigen::MatrixXd& A);
  /// x = A^-1 b; x may be b. No allocation.
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) const;

 private:
  int n_, packs_;
  std::vector<Pack> columns_;  ///< of the inverse, `packs_` to a column
};

}  // namespace cagetol
