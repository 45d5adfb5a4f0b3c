#include "src/numerics/small_inverse.hpp"

#include <algorithm>
#include <cmath>

namespace cagetol {
namespace {

/// Gauss-Jordan in place on n vectors of `packs` packs: turns the columns of a matrix into those of
/// its inverse (on rows it would turn rows into rows).
template <int packs>
bool invert_vectors(Pack* vectors, int n) {
  const Pack lane = {0, 1, 2, 3, 4, 5, 6, 7};
  bool sound = true;
  for (int k = 0; k < n; ++k) {
    Pack* const pivot_vector = vectors + k * packs;
    const int at = k / kLanes;
    const Mask here = lane == static_cast<double>(k % kLanes);
    const double pivot = reinterpret_cast<const double*>(pivot_vector)[k];
    if (!(std::abs(pivot) > 0) || !std::isfinite(pivot)) sound = false;
    const double inverse = 1 / pivot;
    Pack scaled[packs];
    for (int p = 0; p < packs; ++p) scaled[p] = pivot_vector[p] * inverse;
    scaled[at] = select(here, splat(inverse), scaled[at]);
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      Pack* const vector = vectors + i * packs;
      const double factor = reinterpret_cast<const double*>(vector)[k];
      for (int p = 0; p < packs; ++p) {
        const Pack kept = p == at ? select(here, Pack{}, vector[p]) : vector[p];
        vector[p] = kept - factor * scaled[p];
      }
    }
    for (int p = 0; p < packs; ++p) pivot_vector[p] = scaled[p];
  }
  return sound;
}

}  // namespace

SmallInverse::SmallInverse(int n)
    : n_(n), packs_(packs_for(n)), columns_(static_cast<std::size_t>(n * packs_)) {}

bool SmallInverse::invert(const Eigen::Ref<const Eigen::MatrixXd>& A) {
  for (int j = 0; j < n_; ++j)
    std::copy(A.col(j).data(), A.col(j).data() + n_,
              reinterpret_cast<double*>(columns_.data() + j * packs_));
  return with_packs(packs_,
                    [&]<int packs>() { return invert_vectors<packs>(columns_.data(), n_); });
}

void SmallInverse::solve(const double* b, double* x) const {
  with_packs(packs_, [&]<int packs>() { multiply<packs>(columns_.data(), n_, n_, b, x); });
}

}  // namespace cagetol
