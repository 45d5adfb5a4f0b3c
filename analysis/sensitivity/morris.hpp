// Screening by elementary effects (Morris 1991, doi:10.1080/00401706.1991.10484804; Campolongo et
// al. 2007).
//
// A trajectory moves one group at each step by delta in the unit cube. The elementary effect
//   d = (f(after) - f(before)) / delta
// is in the unit of the output per full range of the input. mean |d| measures how much a group
// matters, the scatter of d how nonlinear it is or how much it interacts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/study/estimate.hpp"
#include "analysis/study/study_data.hpp"

namespace cagetol {

struct ElementaryEffects {
  std::string group;
  std::size_t steps = 0;               ///< steps with a value on both sides
  double mean_magnitude = kUndefined;  ///< mu*
  double mean = kUndefined;     ///< mu; for groups of several columns the sign follows the first
  double scatter = kUndefined;  ///< sigma
};

/// Throws Refused unless the design is morris.
std::vector<ElementaryEffects> elementary_effects(const StudyData& runs,
                                                  std::span<const double> output);

}  // namespace cagetol
