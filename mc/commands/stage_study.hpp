// The study that a stage of a recommendation runs, and commands that make runs of a study in
// stages.
#pragma once

#include "analysis/tolerance/campaign.hpp"
#include "mc/commands/command.hpp"
#include "mc/study/study.hpp"
#include "mc/sweep/staged_sweeps.hpp"

namespace cagetol {

/// `base` with the rows and tolerances of the stage and random numbers of its own, which follow
/// from the study's seed and the stage's name.
Study stage_study(const Study& base, const Stage& stage);

/// Runs a stage's study of the design "random" in a directory that may hold fewer rows of it: they
/// are finished and keep their runs. The exit code of StagedSweeps::sweep.
int sweep_grown(const Study& study, const std::string& directory, StagedSweeps& stages);

/// What such a command leads on rank 0, with the study on the rung that its fidelity chooses.
using LeadStages = std::function<int(const Study& base, StagedSweeps& stages)>;

/// Every rank calls it, as run_staged. Throws InputError on rank 0 where there is nothing to judge,
/// the machine has too little memory or disk, or the directory holds a sweep.
int run_staged_study(const std::function<Study()>& read, const MakePlan& make_plan,
                     const std::string& directory, ProgressStyle progress, const LeadStages& lead);

/// Declares STUDY, -o, --set and --progress; what it returns reads the study, says what is worth
/// knowing of it and runs it.
Chosen add_staged_study(CLI::App& command, const std::string& directory_text,
                        int (*run)(const std::function<Study()>& read, const MakePlan& make_plan,
                                   const std::string& directory, ProgressStyle progress));

}  // namespace cagetol
