// First-order share by ranks (Chatterjee 2021, doi:10.1080/01621459.2020.1758115; Gamboa et al.
// 2022, doi:10.3150/21-BEJ1400).
//
// With the runs in the order of X, the last one followed by the first,
//   S = (1/N sum_i Y_(i) Y_(i+1) - mean^2) / Var(Y)
// The estimate needs independent rows. With scrambled Sobol' points, neighbours in X are not random
// in the other inputs, and it does not converge. It is used to check the binned share.
#pragma once

#include <span>

#include "analysis/study/study_data.hpp"

namespace cagetol {

/// Throws Refused unless runs are independent and no value of the feature occurs twice: the order
/// of equal values is arbitrary.
double rank_share(const StudyData& runs, std::span<const double> feature,
                  std::span<const double> output);

}  // namespace cagetol
