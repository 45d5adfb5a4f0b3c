// First-order and total shares of variance of input groups from a pick-freeze design (Jansen 1999,
// doi:10.1016/S0010-4655(98)00154-4).
//
// A and B are independent points, AB_g is A with group g taken from B:
//
//   T_g = E[(f(A) - f(AB_g))^2] / (2 Var Y)          total: g alone and in all interactions
//   S_g = 1 - E[(f(B) - f(AB_g))^2] / (2 Var Y)      first order: g alone
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
