#include "mc/commands/ladder_stages.hpp"

#include "mc/commands/command.hpp"
#include "mc/sweep_directory.hpp"

namespace cagetol {

std::variant<ModelLadder, int> climb(const Study& study, const std::vector<Rung>& rungs,
                                     const LadderOptions& options, const std::string& directory,
                                     StagedSweeps& stages) {
  std::vector<LadderRung> names;
  std::vector<StudyData> runs;
  for (const Rung& rung : rungs) {
    const std::string folder = directory + "/" + rung.name;
    const int code = stages.sweep(rung_study(study, rung, options.samples), folder);
    if (code != kDone) return code;
    runs.push_back(read_study_data(study_file_path(folder)));
    names.push_back({rung.name, rung.meaning, rung.settings});
  }
  ModelLadder ladder = make_model_ladder(
      std::move(names), runs,
      {.study_samples = ladder_study_samples(study), .budget_share = options.budget_share});
  ladder.study = study.name;
  return ladder;
}

}  // namespace cagetol
