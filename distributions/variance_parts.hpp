// Variance of measured parts that come in groups, such as the pockets of cages: a part that a group
// shares, and one that each part has by itself (one-way random effects; Searle, Casella & McCulloch
// 1992, Variance Components, ch. 3):
//
//   x_ij = mean + a_i + e_ij,   sd(a) = group_sigma,   sd(e) = own_sigma
//
// With k groups of n_i parts, N in all, n the harmonic mean of n_i and x_i the mean of a group
// (Thomas & Hultquist 1978, doi:10.1214/aos/1176344202; exact where all groups are equally large):
//
//   between = n sum (x_i - mean)^2 / (k - 1)          with E = own_sigma^2 + n group_sigma^2
//   within  = sum (x_ij - x_i)^2 / (N - k)            with E = own_sigma^2
//
// Intervals are generalised ones (Weerahandi 1993, doi:10.1080/01621459.1993.10476355): both mean
// squares follow chi-square laws and the mean a normal one, and the processes that these allow for
// what was measured are drawn at the points of a lattice. They hold for normal scatter.
#pragma once

#include <functional>
#include <vector>

#include "distributions/laws/interval.hpp"

namespace cagetol {

/// Fewer groups say little of how groups differ.
inline constexpr std::size_t kFewGroups = 10;

/// In the unit of the parts.
struct PartsProcess {
  double mean = 0, group_sigma = 0, own_sigma = 0;
  double total_sigma() const;
};

struct VarianceParts {
  PartsProcess estimate;              ///< a negative variance is 0
  std::vector<PartsProcess> allowed;  ///< equally likely ones
};

/// NaN: a part without a value. One group: parts that share nothing. Throws std::invalid_argument
/// for a group without a value and for fewer than two values.
VarianceParts variance_parts(std::vector<std::vector<double>> groups);

/// Two-sided interval of what `value` says of a process.
Interval interval_of(const std::vector<PartsProcess>& allowed,
                     const std::function<double(const PartsProcess&)>& value, double confidence);

}  // namespace cagetol
