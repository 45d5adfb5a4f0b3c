// Inverse of a small square matrix without pivoting, whole packs of a column at a time. For
// matrices whose symmetric part is positive definite: then no pivot vanishes. A product with the
// inverse has no chain of dependent operations, which two triangles have: it pays from the second
// right-hand side on.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "src/numerics/pack_matrix.hpp"

namespace cagetol {

class SmallInverse {
 public:
  static constexpr int kMost = kMostPacks * kLanes;  ///< largest n
  explicit SmallInverse(int n);

  /// The matrix, to be filled before invert(): afterwards it holds the inverse.
  auto matrix() {
    return Eigen::Map<Eigen::MatrixXd, Eigen::AlignedMax, Eigen::OuterStride<>>(
        reinterpret_cast<double*>(columns_.data()), n_, n_, Eigen::OuterStride<>(packs_ * kLanes));
  }
  /// Inverts in place. False where a pivot vanishes or is not a number. No allocation.
  bool invert();
  /// x = A^-1 b, both of n numbers; x may be b. No allocation.
  void solve(const double* b, double* x) const;

 private:
  int n_, packs_;
  std::vector<Pack> columns_;  ///< `packs_` to a column
};

}  // namespace cagetol
