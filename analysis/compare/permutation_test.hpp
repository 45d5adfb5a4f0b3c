// Permutation test for a difference of two means, without assumptions on the law of the values.
//
// If nothing has changed, the labels old and new are random. They are drawn again: clusters are
// assigned at random to the two samples or, if the same cages ran twice, each pair is swapped at
// random. The p-value is the share of draws, the observed one included, whose means differ at least
// as much as the observed ones (Phipson and Smyth 2010, doi:10.2202/1544-6115.1585). Drawing stops
// early when the p-value is certain to be large (Besag and Clifford 1991,
// doi:10.1093/biomet/78.2.301). The test is exact in both cases, also for heavy tails and for
// quantities that rarely vary.
#pragma once

#include <cstdint>
#include <vector>

namespace cagetol {

/// Values of one sample (NaN: no value) and the cluster of each run.
struct ClusteredValues {
  std::vector<std::int64_t> cluster;
  std::vector<double> value;
};

/// Two-sided p-value of the difference of the means, at least 1/50,000. `paired`: clusters with
/// equal labels are the same cages, run again; clusters in only one sample are left out. The draws
/// depend on the seed only.
double permutation_p_value(const ClusteredValues& before, const ClusteredValues& after, bool paired,
                           std::uint64_t seed);

}  // namespace cagetol
