// Is one statistic of a study another one than before?
//
// Runs come in clusters within which they depend on each other: cages of a lot, points of a Sobol'
// scramble. A smooth statistic is linearised; the sums of its influence over the clusters give its
// variance, and Student's t the p-value (degrees of freedom: clusters - 1, Welch for two samples).
// A share of independent runs has an exact test instead: Fisher's, or McNemar's where the same rows
// were run twice.
#pragma once

#include <cstdint>
#include <vector>

namespace cagetol {

/// One sample of a statistic: the influence of each cluster on it (they sum to zero), by the
/// cluster's label.
struct Linearised {
  double value = 0;
  std::vector<std::int64_t> cluster;  ///< of each run
  std::vector<double> influence;      ///< of each run; 0 where the run does not enter
};

/// Two-sided p-value of a change. `paired`: equal labels are the same cages, run again.
double change_p_value(const Linearised& before, const Linearised& after, bool paired);

/// Runs that have a property, of all.
struct Share {
  std::size_t count = 0, runs = 0;
};

/// Fisher's exact test, two-sided: all tables at most as probable as the one seen.
double fisher_p_value(const Share& before, const Share& after);

/// McNemar's exact test, two-sided, from the rows that changed: `gained` and `lost` the property.
double mcnemar_p_value(std::size_t gained, std::size_t lost);

}  // namespace cagetol
