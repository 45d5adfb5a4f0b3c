// Change of a share between two conditions with paired runs, exactly.
//
// Of n pairs, g gain (miss in the first, meet in the second), l lose. With the shares psi of pairs
// that differ and pi of gains among these, the change is
//   delta = p_gain - p_lose = psi (2 pi - 1)
// No change means pi = 1/2. Given d = g + l, g is binomial with pi: McNemar's test with its exact
// law (Dixon & Mood 1946, doi:10.1080/01621459.1946.10501898).
//
// Each end of the interval at confidence 1 - alpha joins two Clopper-Pearson bounds, that of pi
// given d at 0.8 alpha / 2 and that of psi at 0.2 alpha / 2, so that it covers delta with at least
// 1 - alpha, whatever psi (Bonferroni).
#pragma once

#include <cstddef>

#include "analysis/study/estimate.hpp"

namespace cagetol {

struct PairedShare {
  std::size_t pairs = 0, gained = 0, lost = 0;
  Estimate change;     ///< delta
  double p_value = 1;  ///< two-sided, of no change
};

/// McNemar's exact test, two-sided, from the numbers of pairs that gained and that lost.
double mcnemar_p_value(std::size_t gained, std::size_t lost);

PairedShare paired_share(std::size_t pairs, std::size_t gained, std::size_t lost,
                         double confidence);

}  // namespace cagetol
