// The rungs of the model ladder as sweeps: DIR/RUNG each.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "analysis/fidelity/model_ladder.hpp"
#include "mc/ladder/rungs.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

struct LadderOptions {
  long samples = 24;
  double budget_share = 0.1;  ///< of the study's standard error
};

/// Runs what is missing of every rung and judges them; or the exit code of the sweep that ended
/// early.
std::variant<ModelLadder, int> climb(const Study& study, const std::vector<Rung>& rungs,
                                     const LadderOptions& options, const std::string& directory,
                                     StagedSweeps& stages);

/// A study with fidelity = "auto" on the rung that its pilot, DIR/fidelity/RUNG, chooses, with the
/// evidence; any other study, and one that is decided, as it is. Or the exit code of the sweep that
/// ended early. The pilot runs the reference, then rungs from the cheapest up to the first that
/// will do for every limited quantity. Throws InputError where the study has no limits to choose
/// by.
std::variant<Study, int> with_fidelity(const Study& study, const std::string& directory,
                                       StagedSweeps& stages);

/// DIR/fidelity, where the pilot's rungs are.
std::string fidelity_folder(const std::string& directory);

}  // namespace cagetol
