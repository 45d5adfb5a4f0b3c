// Tests whether a statistic of a study has changed.
//
// Runs within a cluster are dependent: cages of a lot. A smooth
// statistic is linearised; the sums of its influence over the clusters give its variance, and
// Student's t gives the p-value (degrees of freedom: clusters - 1, Welch for two samples). A share
// of independent runs has an exact test: Fisher's, or McNemar's if the same rows were run twice.
#pragma once

#include <cstdint>
#include <vector>

namespace cagetol {

/// One sample of a statistic: the influence of each run (sum zero) and the cluster of each run.
struct Linearised {
  double value = 0;
  std::vector<std::int64_t> cluster;  ///< of each run
  std::vector<double> influence;      ///< of each run; 0 for a run that does not count
};

/// Two-sided p-value of a change. `paired`: clusters with equal labels are the same cages, run
/// again.
double change_p_value(const Linearised& before, const Linearised& after, bool paired);

/// Number of runs with a property, and of all runs.
struct Share {
  std::size_t count = 0, runs = 0;
};

/// Fisher's exact test, two-sided: sums all tables that are not more probable than the observed
/// one.
double fisher_p_value(const Share& before, const Share& after);

}  // namespace cagetol
