// Mean difference between two conditions whose k-th runs belong together, with Student's t interval
// of the paired differences: d_k = second_k - first_k, mean(d) -+ t(n-1) s(d) / sqrt(n). Holds for
// differences that are about normal, and for any law as n grows.
#pragma once

#include <span>

#include "analysis/statistics/estimate.hpp"

namespace cagetol {

struct PairedDifference {
  std::size_t pairs = 0;                                     ///< with a value on both sides
  std::size_t missing = 0;                                   ///< pairs without
  Estimate difference;                                       ///< no interval below two pairs
  double first_mean = kUndefined, second_mean = kUndefined;  ///< over the pairs
  bool identical = false;                                    ///< every pair agrees to the last bit
};

/// NaN stands for a run without a value. Both spans have one element for each pair.
PairedDifference paired_difference(std::span<const double> first, std::span<const double> second,
                                   double confidence);

}  // namespace cagetol
