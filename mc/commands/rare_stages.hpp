// The runs of `cagetol rare` and the last stage of a recommendation: DIR/rare/pilot, 50 cages that
// run twice, and DIR/rare/tail, fresh cages; sweeps like any other, with rare.json and its figure
// beside them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/tolerance/recommendation.hpp"
#include "mc/host/progress.hpp"
#include "mc/study/study.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

/// Every rank calls it, as run_recommend. At the tolerances to which the study's laws belong.
int run_rare(const std::function<Study()>& read, const MakePlan& make_plan,
             const std::string& directory, ProgressStyle progress);

/// Rank 0, below its stages: writes and says what is found at these tolerances. kDone also where
/// nothing can be stated; else the exit code with which it ended early.
int rare_stage(const Study& base, const std::string& directory,
               const std::vector<RecommendedTolerance>& tolerances, StagedSweeps& stages);

/// What a budget can show, in a sentence for `check`.
std::string rare_budget_text(const Study& study);

}  // namespace cagetol
