// Numerical inverse of a distribution function on x >= 0, for laws without a reliable inverse in
// GSL.
#pragma once

#include <bit>
#include <cstdint>

namespace cagetol {

/// The smallest double x in [0, upper] with cdf(x) >= p, by bisection of the bit pattern. Takes at
/// most 64 steps for any x. The result does not decrease with p, even if rounding errors make cdf
/// not monotonic. For p > 1/2 the survival function is compared with 1 - p, which keeps the
/// accuracy of the upper tail.
template <class Cdf, class Survival>
double invert_cdf(const Cdf& cdf, const Survival& survival, double p, double upper) {
  const auto reached = [&](double x) { return p <= 0.5 ? cdf(x) >= p : survival(x) <= 1 - p; };
  std::uint64_t below = 0;
  std::uint64_t above = std::bit_cast<std::uint64_t>(upper);
  if (p <= 0) return 0;
  while (below + 1 < above) {
    const std::uint64_t middle = below + (above - below) / 2;
    (reached(std::bit_cast<double>(middle)) ? above : below) = middle;
  }
  return std::bit_cast<double>(above);
}

}  // namespace cagetol
