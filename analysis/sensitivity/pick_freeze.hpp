// First-order and total shares of variance of input groups from a pick-freeze design.
//
// A and B are independent points, AB_g is A with group g taken from B; f is centred:
//
//   T_g = E[(f(A) - f(AB_g))^2] / (2 Var Y)               total: g alone and in all interactions
//   S_g = E[f(B) (f(AB_g) - (1 - T_g) f(A))] / Var Y      first order: g alone
//
// T_g: Jansen 1999, doi:10.1016/S0010-4655(98)00154-4. S_g: f(B) f(A) is zero on average and
// correlated with f(B) f(AB_g); 1 - T_g, the correlation of f(A) and f(AB_g), takes most of the
// scatter out. Without the factor this is the estimator of Saltelli et al. 2010,
// doi:10.1016/j.cpc.2009.09.018, without f(A) that of Janon et al. 2014, doi:10.1051/ps/2013040,
// whose Var Y, that of f(B) and f(AB_g) together, is used for both. A share near zero has the
// standard error sqrt((1 - (1 - T_g)^2) / N) from N bases, less than from either and from
// 1 - E[(f(B) - f(AB_g))^2] / (2 Var Y).
//
// Each row has its own noise. Shares refer to the whole variance, noise included. T_g contains the
// noise share in addition; it is subtracted if replicates give it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/study/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct GroupShares {
  std::string group;
  Estimate first_order, total;
};

/// One entry per group, with bootstrap intervals over bases. Bases with a row without a value are
/// left out. Throws Refused unless the design is pick-freeze and correlated inputs are in one
/// group.
std::vector<GroupShares> pick_freeze_shares(const StudyData& runs, std::span<const double> output,
                                            double noise_share, double confidence,
                                            std::size_t resamples);

}  // namespace cagetol
