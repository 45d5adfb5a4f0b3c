// Square matrices over the local directions of a roller, of a pack of rollers side by side.
#pragma once

#include "src/model/bearing_model.hpp"
#include "src/newton/linearisation.hpp"

namespace cagetol {
namespace {  // newton_matrix.cpp alone uses these, and inlines what pays

/// Mass of each local direction of a pack of rollers.
void local_mass(const RollerGroup& roller, Pack (&mass)[kLocalVelocities]) {
  mass[kLr] = mass[kLt] = mass[kLx] = roller.mass;
  mass[kLar] = mass[kLat] = roller.transverse;
  mass[kLs] = roller.polar;
}

using Three = Pack[3][3];

/// Gauss-Jordan in place, without pivoting. Marks lanes in which a pivot is not well above zero (or
/// not a number) against its mass.
[[gnu::always_inline]] inline Mask invert_three(Three& a, const Pack (&minimum)[3]) {
  Mask bad{};
  for (int k = 0; k < 3; ++k) {
    bad |= ~(abs(a[k][k]) > minimum[k]);  // also true for NaN
    const Pack inverse = 1.0 / a[k][k];
    for (int j = 0; j < 3; ++j) a[k][j] *= inverse;
    a[k][k] = inverse;
    for (int i = 0; i < 3; ++i) {
      if (i == k) continue;
      const Pack factor = a[i][k];
      a[i][k] = Pack{};
      for (int j = 0; j < 3; ++j) a[i][j] -= factor * a[k][j];
    }
  }
  return bad;
}

/// x += sign a b.
template <int sign>
[[gnu::always_inline]] inline void add_three(const Three& a, const Three& b, Three& x) {
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        if constexpr (sign > 0)
          x[i][j] += a[i][k] * b[k][j];
        else
          x[i][j] -= a[i][k] * b[k][j];
}

/// Inverts in place, by blocks of three by three, which fit into registers, with the pivots of an
/// elimination without pivoting. False where a pivot of an existing roller is not well above zero
/// (or not a number) against its mass.
bool invert(Pack (&a)[kLocalVelocities][kLocalVelocities], const Pack (&mass)[kLocalVelocities],
            double beta, Pack exists) {
  static_assert(kLocalVelocities == 6);
  constexpr int first[3] = {kLr, kLt, kLx}, second[3] = {kLar, kLat, kLs};
  const auto get = [&](const int(&rows)[3], const int(&columns)[3], Three& to) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) to[i][j] = a[rows[i]][columns[j]];
  };
  const auto put = [&](const Three& from, const int(&rows)[3], const int(&columns)[3]) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a[rows[i]][columns[j]] = from[i][j];
  };
  const auto inverted = [&](const int(&rows)[3], Three& block) {
    const Pack minimum[3] = {1e-9 * mass[rows[0]] / beta, 1e-9 * mass[rows[1]] / beta,
                             1e-9 * mass[rows[2]] / beta};
    return invert_three(block, minimum);
  };
  Three P;
  get(first, first, P);
  Mask bad = inverted(first, P);
  // (P Q; R S)^-1, P inverted: X = P Q, S' = (S - R X)^-1, ...
  Three Q, R, S, X{}, lower{}, right{};
  get(first, second, Q);
  add_three<1>(P, Q, X);
  get(second, first, R);
  get(second, second, S);
  add_three<-1>(R, X, S);
  bad |= inverted(second, S);
  put(S, second, second);
  add_three<-1>(X, S, right);
  put(right, first, second);
  // ... -S' R P below, and P + X S' R P.
  Three RP{};
  add_three<1>(R, P, RP);
  add_three<-1>(S, RP, lower);
  put(lower, second, first);
  add_three<-1>(X, lower, P);
  put(P, first, first);
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

void multiply(const Pack (&a)[kLocalVelocities][kLocalVelocities], const Pack* b, Pack* x) {
  for (int i = 0; i < kLocalVelocities; ++i) {
    // Two sums: neither waits for the other.
    Pack odd = a[i][1] * b[1];
    x[i] = a[i][0] * b[0];
    for (int k = 2; k < kLocalVelocities; ++k) (k % 2 == 0 ? x[i] : odd) += a[i][k] * b[k];
    x[i] += odd;
  }
}

/// x = b A, b a row.
void multiply_left(const Pack* b, const Pack (&a)[kLocalVelocities][kLocalVelocities], Pack* x) {
  for (int j = 0; j < kLocalVelocities; ++j) {
    x[j] = b[0] * a[0][j];
    for (int k = 1; k < kLocalVelocities; ++k) x[j] += b[k] * a[k][j];
  }
}

}  // namespace
}  // namespace cagetol
