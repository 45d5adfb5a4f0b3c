// First-order share by ranks (Chatterjee 2021, doi:10.1080/01621459.2020.1758115; Gamboa et al.
// 2022, doi:10.3150/21-BEJ1400).
//
// With the runs in the order of X, the last one followed by the first,
//   S = (1/N sum_i Y_(i) Y_(i+1) - mean^2) / Var(Y)
// It needs independent rows: on scrambled Sobol' points neighbours in X are not random in the other
// inputs and the estimate does not converge. Used as a second opinion beside the binned share.
#pragma once

#include <span>

#include "analysis/study/study_data.hpp"

namespace cagetol {

/// Throws Refused for every design but `random`.
double rank_share(const StudyDesign& design, std::span<const double> feature,
                  std::span<const double> output);

}  // namespace cagetol
