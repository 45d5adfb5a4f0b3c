// The runs of `cagetol screen` and the first stage of a recommendation: DIR/screen, a sweep like
// any other, with screen.json and its figure beside study.h5.
//
// Each tolerance is screened at the widest candidate of which at most 1 % of the cages jam; what
// jams is drawn again. Lots scatter by that width in all runs, normal with the study's
// mean and variance, and the pockets of a cage by that width or not at all, in all combinations of
// the dimensions. All else is drawn as in the study, all in a Latin hypercube. Eight rows run twice
// and give the noise of the start.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "analysis/tolerance/screen.hpp"
#include "mc/host/progress.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

/// Every rank calls it, as run_recommend.
int run_screen(const std::function<Study()>& read, const MakePlan& make_plan,
               const std::string& directory, ProgressStyle progress);

/// Name of a stage, which gives it random numbers of its own, and its runs, with the key that says
/// how many.
struct ScreenStage {
  std::string name, key;
  long runs = 0;
};

struct ScreenDesign {
  Study study;
  std::vector<ScreenDimension> dimensions;
  double jams = 0, draws = 0;  ///< share that jams, and cages drawn for it
};

/// Throws Refused where so few runs cannot tell the tolerances apart.
ScreenDesign screen_design(const Study& base, const ScreenStage& stage);

/// Rank 0, below its stages: what it found, which is written and said; else the exit code: where it
/// ended early, or kSamplesFailed where too few runs gave a result.
std::variant<Screen, int> screen_stage(const Study& base, const std::string& directory,
                                       StagedSweeps& stages);

}  // namespace cagetol
