// Weights that turn runs sampled over all candidate tolerances into runs of one tolerance
// (deterministic mixture, Owen & Zhou 2000, doi:10.1080/01621459.2000.10473909).
//
// Candidate j was used for the share a_j of the runs (1/K when complete): the runs have the density
// sum_j a_j p_j. A run x counts
//   w_k(x) = p_k(x) / sum_j a_j p_j(x)  <=  1 / a_k   (= K)
// for candidate k. Where runs are of cages that fit, the share 1 - j_k of candidate k's, p_k stands
// for p_k/(1 - j_k). The mean weight is 1 up to sampling. The effective sample size
//   ESS = (sum w)^2 / sum w^2
// is at least about N/K.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/tolerance/fit_share.hpp"

namespace cagetol {

/// Below this effective number of runs a weighted figure is rough, and said to be.
inline constexpr double kFewestEffectiveRuns = 100;
/// Below this one it is not shown as a result. Bounds are sound above: they take the effective
/// number for their number of runs (yield.hpp).
inline constexpr double kMinimumEffectiveRuns = 30;

struct MixtureWeights {
  std::vector<std::vector<double>> candidate;  ///< [candidate][sample]
  std::vector<double>
      log_mixture;  ///< log sum_j a_j p_j(x) of each sample; empty where a law has no density
  std::vector<FitShare> fit;  ///< of each candidate
  std::string
      note;  ///< says so where candidates are judged by their own runs only, for want of a density
};

/// Weights of every candidate of the study.
MixtureWeights mixture_weights(const StudyData& runs);

/// Weights of any other tolerance, given by its scales and the shifts of its centres in the keys'
/// units (empty: none), but for a common factor. No bound holds for them: watch the effective
/// sample size.
std::vector<double> weights_of_scales(const StudyData& runs, const MixtureWeights& mixture,
                                      std::span<const double> scales,
                                      std::span<const double> shifts = {});

/// The same from densities alone: log_densities[candidate][sample], shares a_j of the runs. Fills
/// `log_mixture` if given.
std::vector<std::vector<double>> weights_of_densities(
    const std::vector<std::vector<double>>& log_densities, std::span<const double> shares,
    std::vector<double>* log_mixture = nullptr);

/// Mean of the weights of several candidates: a tolerance drawn from them with equal chance, and
/// the share of its cages that fit.
std::vector<double> average_weights(const MixtureWeights& mixture,
                                    std::span<const std::size_t> candidates);
FitShare average_fit(const MixtureWeights& mixture, std::span<const std::size_t> candidates);

}  // namespace cagetol
