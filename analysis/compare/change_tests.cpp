#include "analysis/compare/change_tests.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace cagetol {
namespace {

using ClusterSums = std::map<std::int64_t, double>;

void add(const Linearised& sample, double sign, ClusterSums& sums) {
  for (std::size_t i = 0; i < sample.influence.size(); ++i)
    sums[sample.cluster[i]] += sign * sample.influence[i];
}

struct Variance {
  double value = 0, freedom = 0;
};
Variance variance_of(const ClusterSums& sums) {
  const auto clusters = static_cast<double>(sums.size());
  Variance variance{0, clusters - 1};
  if (clusters < 2) return {std::nan(""), 0};
  for (const auto& [label, sum] : sums) variance.value += sum * sum;
  variance.value *= clusters / (clusters - 1);
  return variance;
}

double square(double x) {
  return x * x;
}

}  // namespace

double change_p_value(const Linearised& before, const Linearised& after, bool paired) {
  ClusterSums old_sums, new_sums;
  add(after, 1, new_sums);
  Variance variance;
  if (paired) {
    add(before, -1, new_sums);
    variance = variance_of(new_sums);
  } else {
    add(before, 1, old_sums);
    const Variance a = variance_of(old_sums), b = variance_of(new_sums);
    variance.value = a.value + b.value;
    variance.freedom =
        square(variance.value) / (square(a.value) / a.freedom + square(b.value) / b.freedom);
  }
  const double change = std::abs(after.value - before.value);
  if (std::isnan(change) || std::isnan(variance.value)) return 1;
  if (!(variance.value > 0)) return change > 0 ? 0 : 1;
  return 2 * gsl_cdf_tdist_Q(change / std::sqrt(variance.value), variance.freedom);
}

double fisher_p_value(const Share& before, const Share& after) {
  constexpr double kRounding = 1 + 1e-9;
  const auto count = static_cast<unsigned>(before.count + after.count);
  const auto others = static_cast<unsigned>(before.runs + after.runs) - count;
  const auto drawn = static_cast<unsigned>(before.runs);
  const double seen =
      gsl_ran_hypergeometric_pdf(static_cast<unsigned>(before.count), count, others, drawn);
  double p = 0;
  for (unsigned k = drawn > others ? drawn - others : 0; k <= std::min(count, drawn); ++k) {
    const double probability = gsl_ran_hypergeometric_pdf(k, count, others, drawn);
    if (probability <= seen * kRounding) p += probability;
  }
  return std::min(p, 1.0);
}

}  // namespace cagetol
