#include "analysis/statistics/paired_difference.hpp"

#include <gsl/gsl_cdf.h>

#include <cmath>
#include <vector>

namespace cagetol {

PairedDifference paired_difference(std::span<const double> first, std::span<const double> second,
                                   double confidence) {
  PairedDifference result;
  std::vector<double> differences;
  for (std::size_t k = 0; k < first.size(); ++k) {
    if (std::isnan(first[k]) || std::isnan(second[k])) continue;
    differences.push_back(second[k] - first[k]);
  }
  result.pairs = differences.size();
  if (result.pairs == 0) return result;
  const auto count = static_cast<double>(result.pairs);
  double sum = 0;
  for (const double d : differences) sum += d;
  Estimate& mean = result.difference;
  mean.value = sum / count;
  if (result.pairs < 2) return result;
  double squares = 0;
  for (const double d : differences) squares += (d - mean.value) * (d - mean.value);
  const double half = gsl_cdf_tdist_Pinv(0.5 * (1 + confidence), count - 1) *
                      std::sqrt(squares / (count - 1) / count);
  mean.lower = mean.value - half;
  mean.upper = mean.value + half;
  return result;
}

}  // namespace cagetol
