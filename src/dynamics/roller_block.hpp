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

/// Gauss-Jordan in place, without pivoting. False where a pivot of an existing roller is not well
/// above zero (or not a number) against its mass. Directions in which rollers are held have only
/// their mass: a diagonal entry each.
template <bool planar>
bool invert(Pack (&a)[kLocalVelocities][kLocalVelocities], const Pack (&mass)[kLocalVelocities],
            double beta, Pack exists) {
  Mask bad{};
  for (int k = 0; k < kLocalVelocities; ++k) {
    if (held<planar>(k)) {
      a[k][k] = beta / mass[k];
      continue;
    }
    bad |= ~(abs(a[k][k]) > 1e-9 * mass[k] / beta);  // also true for NaN
    const Pack inverse = 1.0 / a[k][k];
    for (int j = 0; j < kLocalVelocities; ++j)
      if (!held<planar>(j)) a[k][j] *= inverse;
    a[k][k] = inverse;
    for (int i = 0; i < kLocalVelocities; ++i) {
      if (i == k || held<planar>(i)) continue;
      const Pack factor = a[i][k];
      a[i][k] = Pack{};
      for (int j = 0; j < kLocalVelocities; ++j)
        if (!held<planar>(j)) a[i][j] -= factor * a[k][j];
    }
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
void multiply(const Pack (&a)[kLocalVelocities][kLocalVelocities], const Pack* b, Pack* x) {
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
void multiply_left(const Pack* b, const Pack (&a)[kLocalVelocities][kLocalVelocities], Pack* x) {
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
