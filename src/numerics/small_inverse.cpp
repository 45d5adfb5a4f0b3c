#include "src/numerics/small_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cagetol {
namespace {

/// Gauss-Jordan in place on n vectors of `packs` packs: turns the columns of a matrix into those of
/// its inverse (on rows it would turn rows into rows).
template <int packs>
bool invert_vectors(Pack* vectors, int n) {
  const Pack lane = {0, 1, 2, 3, 4, 5, 6, 7};
  bool sound = true;
  Pack* const end = vectors + n * packs;
  // `in`: the pack that holds the pivot's row, the only one in which a row is not like the others.
  const auto eliminate_pack = [&]<int in>() {
    for (int k = in * kLanes; k < std::min(n, (in + 1) * kLanes); ++k) {
      Pack* const pivot_vector = vectors + k * packs;
      const double pivot = reinterpret_cast<const double*>(pivot_vector)[k];
      if (!(std::abs(pivot) > 0) || !std::isfinite(pivot)) sound = false;
      const double inverse = 1 / pivot;
      const Mask other = lane != static_cast<double>(k - in * kLanes);  // rows but the pivot's
      Pack scaled[packs];
      for (int p = 0; p < packs; ++p) scaled[p] = pivot_vector[p] * inverse;
      scaled[in] = select(other, scaled[in], splat(inverse));
      const auto eliminate = [&](Pack* from, const Pack* to) {
        for (Pack* vector = from; vector != to; vector += packs) {
          const double factor = reinterpret_cast<const double*>(vector)[k];
          for (int p = 0; p < packs; ++p)
            vector[p] =
                (p == in ? select(other, vector[p], Pack{}) : vector[p]) - factor * scaled[p];
        }
      };
      eliminate(vectors, pivot_vector);
      eliminate(pivot_vector + packs, end);
      for (int p = 0; p < packs; ++p) pivot_vector[p] = scaled[p];
    }
  };
  [&]<int... in>(std::integer_sequence<int, in...>) {
    (eliminate_pack.template operator()<in>(), ...);
  }
  (std::make_integer_sequence<int, packs>());
  return sound;
}

}  // namespace

SmallInverse::SmallInverse(int n)
    : n_(n), packs_(packs_for(n)), columns_(static_cast<std::size_t>(n * packs_)) {}

bool SmallInverse::invert() {
  return with_packs(packs_,
                    [&]<int packs>() { return invert_vectors<packs>(columns_.data(), n_); });
}

void SmallInverse::solve(const double* b, double* x) const {
  with_packs(packs_, [&]<int packs>() { multiply<packs>(columns_.data(), n_, n_, b, x); });
}

}  // namespace cagetol
