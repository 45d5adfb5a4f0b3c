// Square matrices over the local directions of a roller, of a pack of rollers side by side. Those
// of planar rollers have a diagonal entry only where these are held.
#pragma once

#include "src/dynamics/bearing_model.hpp"
#include "src/dynamics/linearisation.hpp"

namespace cagetol {
namespace {  // newton_matrix.cpp alone uses these, and inlines what pays

/// Mass of each local direction of a pack of rollers.
void local_mass(const RollerGroup& roller, Pack (&mass)[kLocalVelocities]) {
  mass[kLr] = mass[kLt] = mass[kLx] = roller.mass;
  mass[kLar] = mass[kLat] = roller.transverse;
  mass[kLs] = roller.polar;
}

using RollerBlock = Pack[kLocalVelocities][kLocalVelocities];

/// A step of Gauss-Jordan in place with the pivots k and, where `pivots` is two, k + 1. Returns the
/// lanes in which a pivot is not well above zero against its `floor`, or is not a number.
template <bool planar, int k, int pivots>
Mask eliminate(RollerBlock& a, const Pack* floor) {
  const auto is_pivot = [&](int i) { return i >= k && i < k + pivots; };
  Mask bad = ~(abs(a[k][k]) > floor[k]);  // also true for NaN
  Pack inverse[pivots][pivots];
  if constexpr (pivots == 1) {
    inverse[0][0] = 1.0 / a[k][k];
  } else {
    const Pack determinant = a[k][k] * a[k + 1][k + 1] - a[k][k + 1] * a[k + 1][k];
    bad |= ~(abs(determinant) > abs(a[k][k]) * floor[k + 1]);
    const Pack per = 1.0 / determinant;
    inverse[0][0] = a[k + 1][k + 1] * per;
    inverse[1][1] = a[k][k] * per;
    inverse[0][1] = -a[k][k + 1] * per;
    inverse[1][0] = -a[k + 1][k] * per;
  }
#pragma GCC unroll 6
  for (int j = 0; j < kLocalVelocities; ++j) {
    if (held<planar>(j) || is_pivot(j)) continue;
    Pack row[pivots];
    for (int p = 0; p < pivots; ++p) row[p] = a[k + p][j];
    for (int p = 0; p < pivots; ++p) {
      a[k + p][j] = inverse[p][0] * row[0];
      for (int q = 1; q < pivots; ++q) a[k + p][j] += inverse[p][q] * row[q];
    }
  }
#pragma GCC unroll 6
  for (int i = 0; i < kLocalVelocities; ++i) {
    if (held<planar>(i) || is_pivot(i)) continue;
    Pack factor[pivots];
    for (int p = 0; p < pivots; ++p) factor[p] = a[i][k + p];
#pragma GCC unroll 6
    for (int j = 0; j < kLocalVelocities; ++j) {
      if (held<planar>(j)) continue;
      Pack left = is_pivot(j) ? Pack{} : a[i][j];
      for (int p = 0; p < pivots; ++p)
        left -= factor[p] * (is_pivot(j) ? inverse[p][j - k] : a[k + p][j]);
      a[i][j] = left;
    }
  }
  for (int p = 0; p < pivots; ++p)
    for (int q = 0; q < pivots; ++q) a[k + p][k + q] = inverse[p][q];
  return bad;
}

/// Gauss-Jordan in place, without pivoting, two pivots at a time: entries are read and written half
/// as often. False where a pivot of an existing roller is not well above zero (or not a number)
/// against its mass. Directions in which rollers are held have only their mass: a diagonal entry
/// each.
template <bool planar>
bool invert(RollerBlock& a, const Pack (&mass)[kLocalVelocities], double beta, Pack exists) {
  Pack floor[kLocalVelocities];
  for (int i = 0; i < kLocalVelocities; ++i) floor[i] = (1e-9 / beta) * mass[i];
  Mask bad = eliminate<planar, kLr, 2>(a, floor);
  if constexpr (planar) {
    for (int i = kLx; i <= kLat; ++i) a[i][i] = beta / mass[i];
    bad |= eliminate<planar, kLs, 1>(a, floor);
  } else {
    bad |= eliminate<planar, kLx, 2>(a, floor);
    bad |= eliminate<planar, kLat, 2>(a, floor);
  }
  return !any(bad & (exists > 0.0));
}

/// By two sums: neither waits for the other.
Pack product(const Pack (&a)[kLocalVelocities], const Pack (&b)[kLocalVelocities]) {
  Pack even = a[0] * b[0], odd = a[1] * b[1];
  for (int k = 2; k < kLocalVelocities; k += 2) {
    even += a[k] * b[k];
    odd += a[k + 1] * b[k + 1];
  }
  return even + odd;
}

template <bool planar>
void multiply(const RollerBlock& a, const Pack* b, Pack* x) {
  for (int i = 0; i < kLocalVelocities; ++i) {
    if (held<planar>(i)) {
      x[i] = a[i][i] * b[i];
      continue;
    }
    // Two sums: neither waits for the other.
    Pack odd = a[i][1] * b[1];
    x[i] = a[i][0] * b[0];
    for (int k = 2; k < kLocalVelocities; ++k)
      if (!held<planar>(k)) (k % 2 == 0 ? x[i] : odd) += a[i][k] * b[k];
    x[i] += odd;
  }
}

/// x = b A, b a row.
template <bool planar>
void multiply_left(const Pack* b, const RollerBlock& a, Pack* x) {
  for (int j = 0; j < kLocalVelocities; ++j) {
    if (held<planar>(j)) {
      x[j] = b[j] * a[j][j];
      continue;
    }
    x[j] = b[0] * a[0][j];
    for (int k = 1; k < kLocalVelocities; ++k)
      if (!held<planar>(k)) x[j] += b[k] * a[k][j];
  }
}

}  // namespace
}  // namespace cagetol
