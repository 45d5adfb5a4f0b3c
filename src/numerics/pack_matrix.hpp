// Products with a small matrix, whole packs of a column at a time.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "src/numerics/pack.hpp"

namespace cagetol {

inline constexpr int kMostPacks = 72 / kLanes;  ///< in a column

inline int packs_for(int n) {
  return (n + kLanes - 1) / kLanes;
}

/// Calls `run` with the number of packs, up to kMostPacks, as a constant.
template <int packs = 1, class Run>
auto with_packs(int count, const Run& run) {
  if constexpr (packs < kMostPacks)
    if (count != packs) return with_packs<packs + 1>(count, run);
  return run.template operator()<packs>();
}

/// x = A b of `rows` and `columns` numbers, A padded to whole packs; x may be b.
template <int packs>
void multiply(const Pack* A, int rows, int columns, const double* b, double* x) {
  Pack even[packs] = {}, odd[packs] = {};
  int k = 0;
  for (; k + 1 < columns; k += 2)
    for (int p = 0; p < packs; ++p) {
      even[p] += b[k] * A[k * packs + p];
      odd[p] += b[k + 1] * A[(k + 1) * packs + p];
    }
  if (k < columns)
    for (int p = 0; p < packs; ++p) even[p] += b[k] * A[k * packs + p];
  for (int p = 0; p < packs; ++p) store_first(x + p * kLanes, even[p] + odd[p], rows - p * kLanes);
}

/// A vector of n numbers in whole packs, zero behind them.
template <int packs>
void load_padded(const double* from, int n, Pack (&to)[packs]) {
  for (int p = 0; p < packs; ++p) to[p] = load_first(from + p * kLanes, n - p * kLanes);
}

/// Of packs the sum, each times its weight.
template <class T>
T weighted_sum(const std::vector<T>& packs, const double* weight) {
  T even{}, odd{};
  const std::size_t n = packs.size();
  for (std::size_t k = 0; k + 1 < n; k += 2) {
    even += weight[k] * packs[k];
    odd += weight[k + 1] * packs[k + 1];
  }
  if (n % 2 == 1) even += weight[n - 1] * packs[n - 1];
  return even + odd;
}

/// y += A x of a square matrix whose columns fill `packs` packs.
template <int packs>
void add_product(const Eigen::MatrixXd& A, const double* x, double* y) {
  const int n = static_cast<int>(A.rows());
  Pack sums[packs];
  load_padded(y, n, sums);
  for (int j = 0; j < n; ++j)
    for (int p = 0; p < packs; ++p) sums[p] += x[j] * load_first(&A(p * kLanes, j), n - p * kLanes);
  for (int p = 0; p < packs; ++p) store_first(y + p * kLanes, sums[p], n - p * kLanes);
}

/// A constant matrix of at most kMostPacks packs of rows.
class PackMatrix {
 public:
  PackMatrix() = default;
  explicit PackMatrix(const Eigen::MatrixXd& from)
      : rows_(static_cast<int>(from.rows())),
        columns_(static_cast<int>(from.cols())),
        packs_(packs_for(rows_)),
        values_(static_cast<std::size_t>(packs_ * columns_)) {
    for (int j = 0; j < columns_; ++j)
      std::copy(from.col(j).data(), from.col(j).data() + rows_,
                reinterpret_cast<double*>(values_.data() + j * packs_));
  }
  int packs() const { return packs_; }
  const Pack* column(int j) const { return values_.data() + j * packs_; }
  /// x = A b; x may be b.
  void multiply(const double* b, double* x) const {
    with_packs(packs_, [&]<int packs>() {
      cagetol::multiply<packs>(values_.data(), rows_, columns_, b, x);
    });
  }

 private:
  int rows_ = 0, columns_ = 0, packs_ = 0;
  std::vector<Pack> values_;
};

}  // namespace cagetol
