// The cubic step of the Adams contact and friction laws.
//
//   STEP(x, x0, h0, x1, h1) = h0 + (h1 - h0) S((x - x0)/(x1 - x0))
//   S(z) = z^2 (3 - 2 z),   z clamped to [0, 1]
//
// Continuous with its first derivative. Source: MSC Adams function reference, STEP.
#pragma once

#include "src/numerics/pack.hpp"

namespace cagetol {

/// S(z), z clamped to [0, 1].
template <class T>
T smooth_step(T z) {
  const T t = min(max(z, T{} + 0.0), T{} + 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// dS/dz; zero outside [0, 1].
template <class T>
T smooth_step_slope(T z) {
  const T t = min(max(z, T{} + 0.0), T{} + 1.0);
  return 6.0 * t * (1.0 - t);
}

/// STEP(x, x0, h0, x1, h1) for x1 > x0.
inline double step(double x, double x0, double h0, double x1, double h1) {
  return h0 + (h1 - h0) * smooth_step((x - x0) / (x1 - x0));
}

}  // namespace cagetol
