// Have two samples the same mean? Without any assumption on how their values scatter.
//
// Where nothing has changed, the labels old and new are as good as drawn by lot. So they are drawn
// again: clusters are dealt out anew to the two samples, or, where the same cages ran twice, change
// sides pair by pair. The p-value is the share of draws whose means differ at least as much as the
// ones seen, the draw seen counted (Phipson and Smyth 2010, doi:10.2202/1544-6115.1585). Drawing
// ends early once the p-value is large for certain (Besag and Clifford 1991,
// doi:10.1093/biomet/78.2.301); either way the test is exact, for heavy tails and for a quantity
// that hardly ever varies too.
#pragma once

#include <cstdint>
#include <vector>

namespace cagetol {

/// Values of one sample, NaN where a run has none, and the cluster of each run.
struct ClusteredValues {
  std::vector<std::int64_t> cluster;
  std::vector<double> value;
};

/// Two-sided p-value of a difference of the means, at least 1 / 50,000. `paired`: equal labels are
/// the same cages, run again; clusters of only one sample are left out then. The seed alone decides
/// what is drawn.
double permutation_p_value(const ClusteredValues& before, const ClusteredValues& after, bool paired,
                           std::uint64_t seed);

}  // namespace cagetol
