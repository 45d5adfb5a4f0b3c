// The study that a stage of a recommendation runs.
#pragma once

#include "analysis/tolerance/campaign.hpp"
#include "mc/study/study.hpp"

namespace cagetol {

/// `base` with the rows and tolerances of the stage and random numbers of its own, which follow
/// from the study's seed and the stage's name.
Study stage_study(const Study& base, const Stage& stage);

}  // namespace cagetol
