// First-order and total shares of variance of input groups from a pick-freeze design (Jansen 1999,
// doi:10.1016/S0010-4655(98)00154-4).
//
// Row A and row B are independent points, AB_g is A with group g taken from B:
//   T_g = E[(f(A) - f(AB_g))^2] / (2 Var Y)          total: g alone and in every interaction
//   S_g = 1 - E[(f(B) - f(AB_g))^2] / (2 Var Y)      first order: g alone
// Each row has its own noise. S_g is the group's share of the whole variance, noise included; T_g
// holds the noise share on top, which is taken off again when the replicates tell it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/statistics/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct GroupShares {
  std::string group;
  Estimate first_order, total;
};

/// One entry for each group, intervals by drawing bases again. Bases with a row that has no value
/// are left out. Throws Refused unless the design is pick-freeze and correlated inputs share a
/// group.
std::vector<GroupShares> pick_freeze_shares(const StudyData& runs, std::span<const double> output,
                                            double noise_share, double confidence,
                                            std::size_t resamples);

}  // namespace cagetol
