// Mean difference between two conditions with paired runs, and its Student's t interval:
//   d_k = second_k - first_k,   mean(d) -+ t(n-1) s(d) / sqrt(n)
// Valid for approximately normal differences, and for any law if n is large.
#pragma once

#include <span>

#include "analysis/study/estimate.hpp"

namespace cagetol {

struct PairedDifference {
  std::size_t pairs = 0;  ///< pairs with both values
  Estimate difference;    ///< needs two pairs for an interval
};

/// NaN: a run without a value. Both spans have one element per pair.
PairedDifference paired_difference(std::span<const double> first, std::span<const double> second,
                                   double confidence);

}  // namespace cagetol
