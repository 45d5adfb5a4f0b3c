// Multifidelity Monte Carlo: the mean of an expensive model with the help of cheap ones
// (Peherstorfer, Willcox, Gunzburger, SIAM J. Sci. Comput. 38 (2016) A3163,
// doi:10.1137/15M1046472). Models f_1 (expensive) ... f_k have costs w_i, standard deviations s_i
// and correlations r_i with f_1. Model i runs on the first m_i of common samples.
//
//   m_1 <= ... <= m_k
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

/// Smallest predicted gain for which cheap models are used. The prediction of a pilot is uncertain.
inline constexpr double kLeastMultifidelityGain = 1.2;

/// With fewer pilot samples the best of many plans would be due to chance.
inline constexpr std::size_t kFewestPilotSamples = 16;

struct MultifidelityPlan {
  std::vector<std::size_t> models;  ///< models used, the expensive one first
  std::vector<double> ratios;       ///< m_i / m_1
  std::vector<double> weights;      ///< a_i
  double gain = 1;                  ///< predicted
};

/// The best plan for these costs from a pilot. `pilot[model][sample]`, the expensive model first,
/// NaN: no value; only samples with a value on every model count. The plan is the expensive model
/// alone, with gain 1, if no plan reaches kLeastMultifidelityGain or the pilot has fewer than
/// kFewestPilotSamples.
MultifidelityPlan plan_multifidelity(std::span<const std::vector<double>> pilot,
                                     std::span<const double> costs);

/// Number of samples of each model of the plan for a given cost, at least 2.
std::vector<std::size_t> multifidelity_counts(const MultifidelityPlan& plan,
                                              std::span<const double> costs, double cost);

struct MultifidelityMean {
  double value = kUndefined;
  double standard_error = kUndefined;
  std::size_t lost = 0;  ///< samples left out of a term because a value is missing
};

/// The mean Q. `values[i]` are the first m_i samples of the plan's i-th model. A sample without a
/// value is left out of the terms that need it, so the mean is that of samples with a result on
/// every model.
MultifidelityMean multifidelity_mean(const MultifidelityPlan& plan,
                                     std::span<const std::vector<double>> values);

}  // namespace cagetol
