// Many tests at once, with few false alarms.
//
// Holm 1979, Scand. J. Stat. 6, 65-70: with the p-values in ascending order,
//   adjusted p_(i) = max_{j <= i} min(1, (m - j + 1) p_(j)).
// The probability that any statistic is called changed although none is stays at most the error
// rate, however the statistics depend on each other - and those of one run depend strongly. A false
// discovery rate (Benjamini-Hochberg) would let a night with one true change raise several false
// ones; an alarm is read by people, so each one has to count.
#pragma once

#include <vector>

namespace cagetol {

/// Adjusted p-values in the order given.
std::vector<double> holm_adjusted(const std::vector<double>& p_values);

}  // namespace cagetol
