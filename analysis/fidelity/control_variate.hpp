// Statistics of a dear model with the help of one cheap model on the same samples and many more:
// mean, standard deviation and yield. Each is the mean of a function h of a run, helped by a
// function c of the cheap run (control variate; Peherstorfer et al. 2016, multifidelity.hpp;
// Gorodetsky et al., J. Comput. Phys. 408 (2020) 109257, doi:10.1016/j.jcp.2020.109257):
//   Q = mean over N of (h - a c) + a mean over M of c,  a = cov(h, c) / var(c) from the N pairs
//   mean                h = f                              c = g
//   standard deviation  h = (f - Q of the mean)^2          c = (g - mean over M of g)^2, root of Q
//   yield               h = 1 where f meets the limits     c = P(f meets the limits | g),
//     f | g taken as normal about its regression on g; a wrong c costs gain, never makes Q wrong
// f: dear, g: cheap model, N: samples of f, M > N: samples of g, the first N the same. At equal
// cost plain Monte Carlo has N + M w samples of f, w: cost of g over that of f, so that
//   gain = (var(h) / (N + M w)) / var(Q),  var(Q) = var(h) (1 - r^2 (1 - N / M)) / N,
// r: correlation of h and c. That a is fitted to the same pairs biases Q by O(1 / N).
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

/// Runs of both models, NaN where a run gave none: its sample leaves the terms that need it.
/// `dear` are the first samples of `cheap`.
struct PairedRuns {
  std::span<const double> dear, cheap;
};

struct HelpedEstimate {
  double value = kUndefined, standard_error = kUndefined;
  double plain = kUndefined, plain_error = kUndefined;  ///< of the dear runs alone
  double correlation = kUndefined;                      ///< of h and c
  std::size_t lost = 0;                                 ///< samples left out for want of a value
};

/// The yield needs `limits` on the quantity; a mean and a deviation have none. Undefined with fewer
/// than kFewestPilotSamples pairs or without scatter.
HelpedEstimate helped_estimate(HelpedStatistic statistic, const PairedRuns& runs,
                               std::span<const Limit> limits);

/// At equal cost, by the formula above; 0 for a correlation that is not known.
double gain_at_cost(double correlation, double samples, double cheap_samples, double cost);

/// The number of cheap runs for each dear one that gains most: sqrt(r^2 / (w (1 - r^2))), at
/// least 1.
double best_cheap_ratio(double correlation, double cost);

/// Gain as it shows when the runs are drawn again, pairs among pairs and the other cheap runs among
/// themselves: variance of the plain statistic over `resamples` resamples, for the same cost, over
/// that of the helped one, each time fitted anew.
double resampled_gain(HelpedStatistic statistic, const PairedRuns& runs,
                      std::span<const Limit> limits, double cost, std::uint64_t seed,
                      int resamples);

}  // namespace cagetol
