// Limits that the nominal bearing sets: at most what it has under the least load that its maker
// allows. A cage that slips more at a larger load is worse than any bearing within these rules.
#pragma once

#include "mc/study/study.hpp"

namespace cagetol {

/// Gives each limit with minimum_loads and without a maximum its value: the mean over eight places
/// of the cage's start of the nominal bearing with a rigid cage, at the limit's operating point and
/// the temperature found there. Throws InputError where no minimum load is known or a run fails.
void find_nominal_limits(Study& study);

}  // namespace cagetol
