#include "src/numerics/small_lu.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {

SmallLu::SmallLu(int n)
    : n_(n),
      packs_((n + kLanes - 1) / kLanes),
      lower_(static_cast<std::size_t>(n * packs_)),
      upper_(lower_.size()),
      column_(static_cast<std::size_t>(packs_)),
      inverse_(static_cast<std::size_t>(n)) {}

bool SmallLu::factor(const Eigen::MatrixXd& A) {
  // Left-looking: a column meets all finished columns, then splits into its upper and lower part.
  bool sound = true;
  double* const column = reinterpret_cast<double*>(column_.data());
  for (int j = 0; j < n_; ++j) {
    std::fill(column_.begin(), column_.end(), Pack{});
    std::copy(A.col(j).data(), A.col(j).data() + n_, column);
    for (int k = 0; k < j; ++k) {
      const double above = column[k];
      if (above == 0) continue;
      const Pack* lower = lower_.data() + k * packs_;
      for (int p = k / kLanes; p < packs_; ++p)
        column_[static_cast<std::size_t>(p)] -= above * lower[p];
    }
    const double pivot = column[j];
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot)) sound = false;
    const double inverse = inverse_[static_cast<std::size_t>(j)] = 1 / pivot;
    double* const lower = reinterpret_cast<double*>(lower_.data() + j * packs_);
    double* const upper = reinterpret_cast<double*>(upper_.data() + j * packs_);
    for (int i = 0; i < n_; ++i) {
      upper[i] = i < j ? column[i] : 0;
      lower[i] = i > j ? column[i] * inverse : 0;
    }
  }
  return sound;
}

void SmallLu::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  double* const entry = reinterpret_cast<double*>(column_.data());
  std::copy(b.data(), b.data() + n_, entry);
  for (int k = 0; k < n_; ++k) {
    const Pack* lower = lower_.data() + k * packs_;
    const double above = entry[k];
    for (int p = k / kLanes; p < packs_; ++p)
      column_[static_cast<std::size_t>(p)] -= above * lower[p];
  }
  for (int k = n_ - 1; k >= 0; --k) {
    const Pack* upper = upper_.data() + k * packs_;
    const double found = entry[k] *= inverse_[static_cast<std::size_t>(k)];
    for (int p = 0; p <= k / kLanes; ++p) column_[static_cast<std::size_t>(p)] -= found * upper[p];
  }
  std::copy(entry, entry + n_, x.data());
}

}  // namespace cagetol
