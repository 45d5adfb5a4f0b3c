// Yield: the probability that a run of a random cage meets its limits.
#pragma once

#include <span>
#include <string>

#include "analysis/statistics/resampling.hpp"
#include "analysis/study/judgement.hpp"

namespace cagetol {

/// Shares are weighted. With equal weights they are counts divided by the number of runs.
struct Yield {
  double runs = 0;             ///< samples with an outcome
  double ess = 0;              ///< effective number of runs, (sum w)^2 / sum w^2
  double missing_runs = 0;     ///< samples that miss a limit or jam, counted without weights
  double unknown_runs = 0;     ///< samples without a judgement, counted without weights
  double if_unknown_fail = 0;  ///< yield if all unknown samples fail
  double if_unknown_pass = 0;  ///< yield if all unknown samples pass
  double lower_bound = 0;      ///< one-sided bound of `if_unknown_fail`
  double upper_bound = 1;      ///< one-sided bound of `if_unknown_pass`
  std::string method;          ///< how the bounds were computed
  double fits = 1;             ///< share of cages that fit, contained in the yield (fit_share.hpp)
  bool pooled = false;         ///< estimated from other candidates' runs: its bounds claim nothing
};

/// (sum w)^2 / sum w^2; 0 without weight.
double effective_sample_size(std::span<const double> weights);

/// Independent runs of equal weight have exact Clopper-Pearson bounds. Other runs have the wider of
/// two bounds: bootstrap over lots, and Clopper-Pearson with the effective number of runs
///   n* = y (1 - y) / Var(y),   Var linearised over lots
/// With fewer than five effective failures, (1 - y) ESS < 5, Var is unreliable, and n* is limited
/// to the effective sample size. Runs without any failure thus never have the bound 1. Shares and
/// bounds are NaN where the rows do not follow the laws of the inputs; `method` is then the reason.
Yield estimate_yield(const StudyData& runs, std::span<const Judgement> judgements,
                     std::span<const double> weights, const Resampling& resampling,
                     double confidence);

}  // namespace cagetol
