// The mean of a dear model with the help of cheap ones: multifidelity Monte Carlo (Peherstorfer,
// Willcox, Gunzburger, SIAM J. Sci. Comput. 38 (2016) A3163, doi:10.1137/15M1046472). Models
// f_1 (dear) ... f_k with costs w_i, standard deviations s_i and correlations r_i with f_1, all on
// the first m_i of common samples, m_1 <= ... <= m_k:
//
//   Q         = sum_i mean over the first m_i of (a_i f_i - a_{i+1} f_{i+1})
//   a_i       = r_i s_1 / s_i,   a_1 = 1,   a_{k+1} = r_{k+1} = 0
//   m_i / m_1 = sqrt(w_1 (r_i^2 - r_{i+1}^2) / (w_i (1 - r_2^2)))
//   gain      = variance of plain Monte Carlo at equal cost over that of Q
//             = 1 / (sum_i sqrt(w_i / w_1 (r_i^2 - r_{i+1}^2)))^2
//
// Holds where
//   w_{i-1} / w_i > (r_{i-1}^2 - r_i^2) / (r_i^2 - r_{i+1}^2)
// Models for which it does not hold are left out.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "analysis/statistics/estimate.hpp"

namespace cagetol {

/// Below this the dear model alone is as good: what a pilot predicts is itself uncertain.
inline constexpr double kLeastMultifidelityGain = 1.2;

/// The best of many plans from fewer samples would be chance.
inline constexpr std::size_t kFewestPilotSamples = 16;

struct MultifidelityPlan {
  std::vector<std::size_t> models;  ///< that take part, the dear one first
  std::vector<double> ratios;       ///< m_i / m_1
  std::vector<double> weights;      ///< a_i
  double gain = 1;                  ///< predicted
};

/// The best plan for these costs, from a pilot: `pilot[model][sample]`, the dear model first, NaN
/// where a run gave none. A sample counts only with a value on every model. The dear model alone,
/// gain 1, where no plan gains kLeastMultifidelityGain or the pilot has fewer than
/// kFewestPilotSamples.
MultifidelityPlan plan_multifidelity(std::span<const std::vector<double>> pilot,
                                     std::span<const double> costs);

/// How many samples each model of the plan gets for this cost, at least 2.
std::vector<std::size_t> multifidelity_counts(const MultifidelityPlan& plan,
                                              std::span<const double> costs, double cost);

struct MultifidelityMean {
  double value = kUndefined;
  double standard_error = kUndefined;
  std::size_t lost = 0;  ///< samples left out of a term for want of a value
};

/// `values[i]` are the first m_i samples of the plan's i-th model. A sample without a value leaves
/// the terms that need it: the mean is that of samples which give a result on every model.
MultifidelityMean multifidelity_mean(const MultifidelityPlan& plan,
                                     std::span<const std::vector<double>> values);

}  // namespace cagetol
