// What of a study cannot be judged: one list for `check`, `sweep` and `recommend`.
#pragma once

#include <vector>

#include "mc/study/study.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {

/// Limits on what the scene does not define; where tolerances are asked for, designs, targets and
/// budgets that can confirm none. `recommend` refuses a study for the first, others warn of all.
std::vector<InputError> judgement_faults(const Study& study);

/// What `screen` and `recommend` cannot do without. Throws InputError.
void require_limits_and_candidates(const Study& study);

/// Of the screen and the pilot of `recommend`.
std::size_t first_runs_of(const Study& study);

}  // namespace cagetol
