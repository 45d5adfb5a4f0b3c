#include "mc/commands/ladder_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>

#include "mc/commands/command.hpp"
#include "mc/host/build_info.hpp"
#include "mc/host/file_write.hpp"
#include "mc/sweep/adopted_runs.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

std::string reason_of(const ModelLadder& ladder, std::size_t chosen, long pilot_samples) {
  if (chosen + 1 < ladder.rungs.size())
    return "the cheapest rung that is good enough for every limited quantity";
  if (ladder.samples < static_cast<std::size_t>(pilot_samples))
    return fmt::format("the highest rung: a first look at {} samples finds no other within reach",
                       ladder.samples);
  std::string open;
  for (const LadderQuantity& quantity : ladder.quantities)
    if (quantity.limited() && !quantity.ladder.minimum)
      open += (open.empty() ? "" : ", ") + quantity.name;
  if (open.empty())
    return "the highest rung: no cheaper one is good enough for every limited quantity";
  return fmt::format("the highest rung: {} samples do not decide it for {}", ladder.samples, open);
}

FidelityDecision decision_of(const ModelLadder& ladder, long pilot_samples) {
  const std::size_t chosen = chosen_rung(ladder);
  FidelityDecision decision;
  decision.rung = ladder.rungs[chosen].name;
  decision.reason = reason_of(ladder, chosen, pilot_samples);
  for (const LadderQuantity& quantity : ladder.quantities) {
    if (!quantity.limited()) continue;
    for (std::size_t r = 0; r + 1 < ladder.rungs.size(); ++r) {
      const RungShift& rung = quantity.ladder.rungs[r];
      if (rung.verdict == RungVerdict::settled) decision.assumption = kSettledAssumption;
      decision.shifts.push_back({.quantity = quantity.name,
                                 .rung = ladder.rungs[r].name,
                                 .shift = rung.shift.value,
                                 .lower = rung.shift.lower,
                                 .upper = rung.shift.upper,
                                 .budget = quantity.ladder.budget,
                                 .verdict = rung_verdict_name(rung.verdict),
                                 .limit = limits_text(quantity.limits),
                                 .wrong_share = rung.wrong_share,
                                 .allowed_wrong_share = quantity.ladder.allowed_wrong_share});
    }
  }
  return decision;
}

/// The sweeps of one climb. Rungs are run in any order and judged against the last one of `rungs`.
class Climb {
 public:
  Climb(const Study& study, const std::vector<Rung>& rungs, const LadderOptions& options,
        const std::string& directory, StagedSweeps& stages)
      : study_(study), rungs_(rungs), options_(options), directory_(directory), stages_(stages) {}

  /// Runs what is missing of that rung, beyond what `other` has run of it. Exit code of the sweep.
  int run(std::size_t rung, const Climb* other = nullptr) {
    const Study study = rung_study(study_, rungs_[rung], options_.samples);
    if (other) adopt_runs(study, folder(rung), other->folder(rung));
    const int code = stages_.sweep(study, folder(rung));
    if (code == kDone) runs_.emplace(rung, read_study_data(study_file_path(folder(rung))));
    return code;
  }
  /// Of the rungs that have been run.
  ModelLadder ladder() const {
    std::vector<LadderRung> names;
    std::vector<StudyData> runs;
    for (const auto& [rung, data] : runs_) {
      names.push_back({rungs_[rung].name, rungs_[rung].meaning, rungs_[rung].settings});
      runs.push_back(data);
    }
    ModelLadder ladder = make_model_ladder(
        std::move(names), runs,
        {.study_samples = ladder_study_samples(study_), .budget_share = options_.budget_share});
    for (std::size_t rung = 0; rung < rungs_.size(); ++rung)
      if (!runs_.contains(rung)) ladder.not_run.push_back(rungs_[rung].name);
    ladder.study = study_.name;
    ladder.resolved_study = nlohmann::ordered_json::parse(study_.resolved_json);
    ladder.build = build_id(build_info());
    return ladder;
  }

 private:
  std::string folder(std::size_t rung) const { return directory_ + "/" + rungs_[rung].name; }

  const Study& study_;
  const std::vector<Rung>& rungs_;
  const LadderOptions& options_;
  std::string directory_;
  StagedSweeps& stages_;
  std::map<std::size_t, StudyData> runs_;  ///< by place on the ladder
};

/// Samples of the first look at a rung.
constexpr long kFirstLook = 3;

/// Whether no rung from `rung` up can be expected to do, by what a first look shows: for some
/// quantity the pilot leaves a limit open on the reference, and only the mean is left to judge by,
/// out of the study's reach.
bool is_hopeless(const ModelLadder& pilot, const ModelLadder& look, std::size_t rung) {
  for (std::size_t i = 0; i < pilot.quantities.size(); ++i) {
    const QuantityLadder& seen = look.quantities[i].ladder;
    if (pilot.quantities[i].limited() && leaves_limit_open(pilot.quantities[i].ladder) &&
        is_out_of_reach(seen.rungs[rung], look.rule))
      return true;
  }
  return false;
}

/// The evidence, and what each rung cost [runs of the reference].
struct Climbed {
  ModelLadder ladder;
  std::map<std::string, double> cost;
};

/// Of a rung in several climbs the longest counts: it holds the runs of the others.
std::map<std::string, double> cost_of(const std::vector<ModelLadder>& climbs) {
  std::map<std::string, double> cost;
  for (const ModelLadder& climb : climbs)
    for (const LadderRung& rung : climb.rungs)
      cost[rung.name] =
          std::max(cost[rung.name], rung.cost_ratio * static_cast<double>(climb.samples));
  return cost;
}

/// The reference, then rungs from the cheapest up to the first that will do for every limited
/// quantity, or to one at which a first look shows that none above it will: that look is then the
/// evidence.
std::variant<Climbed, int> climb_as_needed(const Study& study, const std::vector<Rung>& rungs,
                                           const LadderOptions& options,
                                           const std::string& directory, StagedSweeps& stages) {
  const std::size_t reference = rungs.size() - 1;
  LadderOptions brief = options;
  brief.samples = std::min(kFirstLook, options.samples);
  Climb pilot(study, rungs, options, directory, stages);
  Climb look(study, rungs, brief, directory + "/first-look", stages);
  if (const int code = pilot.run(reference); code != kDone) return code;
  if (const int code = look.run(reference, &pilot); code != kDone) return code;
  for (std::size_t rung = 0; rung < reference; ++rung) {
    if (const int code = look.run(rung); code != kDone) return code;
    const ModelLadder seen = look.ladder(), known = pilot.ladder();
    if (is_hopeless(known, seen, rung)) return Climbed{seen, cost_of({seen, known})};
    if (const int code = pilot.run(rung, &look); code != kDone) return code;
    if (chosen_rung(pilot.ladder()) == rung) break;
  }
  const ModelLadder known = pilot.ladder();
  return Climbed{known, cost_of({known})};
}

/// What the pilot has cost beyond the runs that the study makes anyway, for people.
void tell_cost(const Climbed& climbed, const FidelityDecision& decision) {
  double cost = 0;
  for (const auto& [rung, runs] : climbed.cost)
    if (rung != decision.rung) cost += runs;
  spdlog::info("fidelity: {}, {}; the pilot cost about {:.1f} runs of {} beyond the study's own",
               decision.rung, decision.reason, cost, climbed.ladder.rungs.back().name);
}

}  // namespace

std::variant<ModelLadder, int> climb(const Study& study, const std::vector<Rung>& rungs,
                                     const LadderOptions& options, const std::string& directory,
                                     StagedSweeps& stages) {
  Climb climb(study, rungs, options, directory, stages);
  for (std::size_t rung = 0; rung < rungs.size(); ++rung)
    if (const int code = climb.run(rung); code != kDone) return code;
  return climb.ladder();
}

std::variant<Study, int> with_fidelity(const Study& study, const std::string& directory,
                                       StagedSweeps& stages) {
  if (study.fidelity != "auto" || !study.fidelity_decision.rung.empty()) return study;
  if (study.limits.empty())
    throw InputError({}, "fidelity", "\"auto\"",
                     "the study has no limits: there is nothing to judge a rung by",
                     "add [[limit]], or give fidelity = \"pinned\"");
  const std::string folder = fidelity_folder(directory);
  const auto rungs = rungs_for(study.scene, climbing_rungs());
  const LadderOptions options{.samples = study.fidelity_samples,
                              .budget_share = study.fidelity_budget};
  const auto climbed = climb_as_needed(study, rungs, options, folder, stages);
  if (const int* code = std::get_if<int>(&climbed)) return *code;
  const ModelLadder& ladder = std::get<Climbed>(climbed).ladder;
  replace_file(folder + "/ladder.json", ladder_json(ladder).dump(1) + "\n");
  const FidelityDecision decision = decision_of(ladder, options.samples);
  tell_cost(std::get<Climbed>(climbed), decision);
  const auto chosen = std::find_if(rungs.begin(), rungs.end(),
                                   [&](const Rung& rung) { return rung.name == decision.rung; });
  return changed_study(study, [&](Study& changed) {
    changed.scene = on_rung(changed.scene, *chosen);
    changed.fidelity_decision = decision;
  });
}

std::string fidelity_folder(const std::string& directory) {
  return directory + "/fidelity";
}

}  // namespace cagetol
