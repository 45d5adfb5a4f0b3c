// Functions whose shares of variance are known exactly.
#pragma once

#include <cmath>
#include <numbers>
#include <span>

namespace cagetol {

/// Ishigami with a = 7, b = 0.1 over the unit cube: S = .313905, .442411, 0; T = .557589, .442411,
/// .243684.
inline double ishigami(std::span<const double> u) {
  const auto x = [&](std::size_t i) { return std::numbers::pi * (2 * u[i] - 1); };
  return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) +
         0.1 * std::pow(x(2), 4) * std::sin(x(0));
}

/// Sobol's G with a = (0, 1, 4.5, 9, 99, 99, 99, 99): S1..4 = .716193, .179048, .023676, .007162;
/// T1..4 = .787144, .242198, .034317, .010460.
inline double g_function(std::span<const double> u) {
  const double a[] = {0, 1, 4.5, 9, 99, 99, 99, 99};
  double product = 1;
  for (std::size_t i = 0; i < u.size(); ++i)
    product *= (std::abs(4 * u[i] - 2) + a[i]) / (1 + a[i]);
  return product;
}

}  // namespace cagetol
