#include "mc/commands/ladder_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "mc/build_info.hpp"
#include "mc/commands/command.hpp"
#include "mc/file_write.hpp"
#include "mc/sweep_directory.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

FidelityDecision decision_of(const ModelLadder& ladder) {
  const std::size_t chosen = chosen_rung(ladder);
  FidelityDecision decision;
  decision.rung = ladder.rungs[chosen].name;
  std::string open;
  for (const LadderQuantity& quantity : ladder.quantities) {
    if (!quantity.limited) continue;
    if (!quantity.ladder.least) open += (open.empty() ? "" : ", ") + quantity.name;
    for (std::size_t r = 0; r + 1 < ladder.rungs.size(); ++r) {
      const RungShift& rung = quantity.ladder.rungs[r];
      decision.shifts.push_back({.quantity = quantity.name,
                                 .rung = ladder.rungs[r].name,
                                 .shift = rung.shift.value,
                                 .lower = rung.shift.lower,
                                 .upper = rung.shift.upper,
                                 .budget = quantity.ladder.budget,
                                 .verdict = rung_verdict_name(rung.verdict)});
    }
  }
  if (chosen + 1 < ladder.rungs.size())
    decision.reason = "the cheapest rung that is adequate for every limited quantity";
  else if (open.empty())
    decision.reason = "the highest rung: no cheaper one is adequate for every limited quantity";
  else
    decision.reason =
        fmt::format("the highest rung: {} samples do not tell for {}", ladder.samples, open);
  return decision;
}

}  // namespace

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
  ladder.resolved_study = nlohmann::ordered_json::parse(study.resolved_json);
  ladder.build = build_id(build_info());
  return ladder;
}

std::variant<Study, int> with_fidelity(const Study& study, const std::string& directory,
                                       StagedSweeps& stages) {
  if (study.fidelity != "auto" || !study.fidelity_decision.rung.empty()) return study;
  if (study.limits.empty())
    throw InputError({}, "fidelity", "\"auto\"",
                     "the study has no limits: there is nothing to judge a rung by",
                     "add [[limit]], or give fidelity = \"pinned\"");
  const std::string folder = directory + "/fidelity";
  const auto climbed = climb(
      study, climbing_rungs(),
      {.samples = study.fidelity_samples, .budget_share = study.fidelity_budget}, folder, stages);
  if (const int* code = std::get_if<int>(&climbed)) return *code;
  const auto& ladder = std::get<ModelLadder>(climbed);
  replace_file(folder + "/ladder.json", ladder_json(ladder).dump(1) + "\n");
  const FidelityDecision decision = decision_of(ladder);
  spdlog::info("fidelity: {}, {}", decision.rung, decision.reason);
  return changed_study(study, [&](Study& changed) {
    changed.scene = on_rung(changed.scene, climbing_rungs()[chosen_rung(ladder)]);
    changed.fidelity_decision = decision;
  });
}

}  // namespace cagetol
