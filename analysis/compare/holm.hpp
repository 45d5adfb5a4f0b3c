// Holm's correction for multiple tests (Holm 1979, Scand. J. Stat. 6, 65-70).
//
// With m p-values in ascending order,
//   adjusted p_(i) = max_{j <= i} min(1, (m - j + 1) p_(j))
//
// The probability of any false alarm is at most the error rate, for any dependence between the
// statistics. (Those of one run are strongly dependent.) The false discovery rate of Benjamini and
// Hochberg would allow false alarms beside a true change. People read these alarms, so every single
// one must be reliable.
#pragma once

#include <vector>

namespace cagetol {

/// Adjusted p-values in the order given.
std::vector<double> holm_adjusted(const std::vector<double>& p_values);

}  // namespace cagetol
