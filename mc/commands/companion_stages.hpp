// The cheap runs beside a study with multifidelity = "auto": DIR/companion/pilot-RUNG,
// DIR/companion.
#pragma once

#include <string>

#include "mc/staged_sweeps.hpp"
#include "mc/study.hpp"

namespace cagetol {

/// Throws InputError where the study has multifidelity and a rung cannot be run: before hours of
/// runs, not after them.
void check_companion(const Study& study);

/// After the study's sweep in DIR: runs its first samples on each rung that is so cheap that it may
/// help, and where what they predict is worth it, the companion on the best one: the study's
/// samples and as many more as gain most, at most for half the study's time. Times are the nominal
/// ones of the rungs, so that clocks decide nothing. Nothing for a study without multifidelity.
/// Returns the exit code of the sweep that ended early, or 0.
int run_companion(const Study& study, const std::string& directory, StagedSweeps& stages);

}  // namespace cagetol
