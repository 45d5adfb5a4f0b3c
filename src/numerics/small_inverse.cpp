#include "src/numerics/small_inverse.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cagetol {
namespace {

/// Inverts the pivots, one number or a block of two by two. False where they have no inverse.
bool invert_pivots(double (&m)[1][1]) {
  const double pivot = m[0][0];
  m[0][0] = 1 / pivot;
  return std::abs(pivot) > 0 && std::isfinite(pivot);
}
bool invert_pivots(double (&m)[2][2]) {
  const double determinant = m[0][0] * m[1][1] - m[0][1] * m[1][0], inverse = 1 / determinant;
  const double first = m[0][0];
  m[0][0] = inverse * m[1][1];
  m[1][1] = inverse * first;
  m[0][1] *= -inverse;
  m[1][0] *= -inverse;
  return std::abs(determinant) > 0 && std::isfinite(determinant);
}

/// Gauss-Jordan in place on n vectors of `packs` packs: turns the columns of a matrix into those of
/// its inverse (on rows it would turn rows into rows). Two pivots at a time: vectors are read and
/// written half as often.
template <int packs>
bool invert_vectors(Pack* vectors, int n) {
  Pack lane;
  for (int i = 0; i < kLanes; ++i) lane[i] = i;
  bool sound = true;
  Pack* const end = vectors + n * packs;
  const auto entry = [](const Pack* vector, int row) {
    return reinterpret_cast<const double*>(vector)[row];
  };
  // `in`: the pack that holds the pivots' rows, the only one in which rows are not all alike.
  const auto eliminate_pivots = [&]<int in, int pivots>(int k) {
    Pack* const pivot_vectors = vectors + k * packs;
    double inverse[pivots][pivots];
    for (int i = 0; i < pivots; ++i)
      for (int j = 0; j < pivots; ++j) inverse[i][j] = entry(pivot_vectors + j * packs, k + i);
    if (!invert_pivots(inverse)) sound = false;
    const double row = k - in * kLanes;
    const Mask other = (lane < row) | (lane > row + (pivots - 1));  // rows but the pivots'
    Pack scaled[pivots][packs];
    for (int j = 0; j < pivots; ++j) {
      for (int p = 0; p < packs; ++p) {
        scaled[j][p] = pivot_vectors[p] * inverse[0][j];
        for (int i = 1; i < pivots; ++i)
          scaled[j][p] += pivot_vectors[i * packs + p] * inverse[i][j];
      }
      const Pack own = select(lane > row, splat(inverse[pivots - 1][j]), splat(inverse[0][j]));
      scaled[j][in] = select(other, scaled[j][in], own);
    }
    const auto eliminate = [&](Pack* from, const Pack* to) {
      for (Pack* vector = from; vector != to; vector += packs) {
        double factor[pivots];
        for (int i = 0; i < pivots; ++i) factor[i] = entry(vector, k + i);
        for (int p = 0; p < packs; ++p) {
          Pack left = p == in ? select(other, vector[p], Pack{}) : vector[p];
          for (int i = 0; i < pivots; ++i) left -= factor[i] * scaled[i][p];
          vector[p] = left;
        }
      }
    };
    eliminate(vectors, pivot_vectors);
    eliminate(pivot_vectors + pivots * packs, end);
    for (int j = 0; j < pivots; ++j)
      for (int p = 0; p < packs; ++p) pivot_vectors[j * packs + p] = scaled[j][p];
  };
  const auto eliminate_pack = [&]<int in>() {
    int k = in * kLanes;
    const int behind = std::min(n, (in + 1) * kLanes);
    for (; k + 1 < behind; k += 2) eliminate_pivots.template operator()<in, 2>(k);
    if (k < behind) eliminate_pivots.template operator()<in, 1>(k);
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
