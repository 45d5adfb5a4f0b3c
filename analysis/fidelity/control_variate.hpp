// Mean, standard deviation and yield of an expensive model with a cheap model as control variate.
// The cheap model runs on the same samples and on many more. Each statistic is the mean of a
// function h of an expensive run, corrected with a function c of the cheap run (Peherstorfer et al.
// 2016, multifidelity.hpp; Gorodetsky et al., J. Comput. Phys. 408 (2020) 109257,
// doi:10.1016/j.jcp.2020.109257):
//
//   Q = mean over N of (h - a c) + a mean over M of c
//   a = cov(h, c) / var(c)                                    from the N pairs
//
//   mean                h = f                              c = g
//   standard deviation  h = (f - Q of the mean)^2          c = (g - mean over M of g)^2, root of Q
//   yield               h = 1 where f meets the limits     c = P(f meets the limits | g)
//
// f: expensive model, g: cheap model, N: samples of f, M > N: samples of g, of which the first N
// are those of f. For the yield, f given g is taken as normal about its regression on g. If this is
// wrong, the gain is smaller but Q is still right. For the same cost, plain Monte Carlo has N + M w
// samples of f, w: cost of g over cost of f. Therefore
//
//   var(Q) = var(h) (1 - r^2 (1 - N / M)) / N
//   gain   = (var(h) / (N + M w)) / var(Q)
//
// r: correlation of h and c. Q has a bias of O(1 / N), because a is fitted to the same pairs.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/estimate.hpp"
#include "analysis/study/study_plan.hpp"

namespace cagetol {

enum class HelpedStatistic { mean, deviation, yield };
const char* helped_statistic_name(HelpedStatistic statistic);

/// Runs of both models. NaN: no value; the sample is left out of the terms that need it. The
/// samples of `expensive` are the first samples of `cheap`.
struct PairedRuns {
  std::span<const double> expensive, cheap;
};

struct HelpedEstimate {
  double value = kUndefined, standard_error = kUndefined;
  double plain = kUndefined, plain_error = kUndefined;  ///< from the expensive runs alone
  double correlation = kUndefined;                      ///< of h and c
  std::size_t lost = 0;                                 ///< samples without a value
};

/// The statistic with the control variate. `limits` are for the yield only. Undefined with fewer
/// than kFewestPilotSamples pairs or without scatter.
HelpedEstimate helped_estimate(HelpedStatistic statistic, const PairedRuns& runs,
                               std::span<const Limit> limits);

/// Gain for the same cost, by the formula above; 0 if the correlation is unknown.
double gain_at_cost(double correlation, double samples, double cheap_samples, double cost);

/// Number of cheap runs per expensive run with the largest gain, at least 1:
///   sqrt(r^2 / (w (1 - r^2)))
double best_cheap_ratio(double correlation, double cost);

/// Achieved gain, by bootstrap: variance of the plain statistic for the same cost over variance of
/// the statistic with control variate, from `resamples` resamples. Pairs and the additional cheap
/// runs are resampled separately, and a is fitted again for each resample.
double resampled_gain(HelpedStatistic statistic, const PairedRuns& runs,
                      std::span<const Limit> limits, double cost, std::uint64_t seed,
                      int resamples);

}  // namespace cagetol
