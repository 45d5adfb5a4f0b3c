#include "mc/commands/recommend_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "analysis/study/refused.hpp"
#include "analysis/tolerance/campaign.hpp"
#include "mc/commands/assumption_stages.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/judgeable.hpp"
#include "mc/commands/rare_stages.hpp"
#include "mc/commands/screen_stages.hpp"
#include "mc/commands/stage_study.hpp"
#include "mc/host/build_info.hpp"
#include "mc/sweep/adopted_runs.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;

CampaignSettings campaign_settings(const Study& study, bool jams_alone) {
  return {.attempts = static_cast<std::size_t>(study.recommend.attempts),
          .confirm_samples = static_cast<std::size_t>(study.recommend.confirm_samples),
          .budget_samples = static_cast<std::size_t>(study.recommend.budget_samples),
          .budget_h = study.recommend.budget_time / 3600,
          .screen_samples = static_cast<std::size_t>(study.screen.budget_samples),
          .jams_alone = jams_alone};
}

constexpr const char* kInterruptedText = "interrupted: start the same command again to go on";

bool same_budget(const CampaignSettings& one, const CampaignSettings& other) {
  return one.confirm_samples == other.confirm_samples &&
         one.budget_samples == other.budget_samples && one.budget_h == other.budget_h;
}

/// Rank 0: decides and leads.
class StageLeader {
 public:
  StageLeader(const Study& base, const RecommendOptions& options, StagedSweeps& stages)
      : base_(base),
        directory_(options.directory),
        stages_(stages),
        unconfirmed_code_(options.exit_code ? kLimitsNotMet : kDone) {}

  int lead();

 private:
  std::string path(const std::string& name) const { return directory_ + "/" + name; }
  std::optional<StudyData> run_stage(const Stage& stage);
  CampaignPlan plan(const StudyData& pilot) const;
  std::optional<CampaignPlan> stored_plan() const;
  void keep(const CampaignPlan& plan) const;
  void begin_attempt(const Study& study, const Stage& stage) const;
  void set_attempts_aside(const CampaignPlan& plan) const;
  bool too_many_lost(const StudyData& runs, const std::string& directory);

  const Study& base_;
  std::string directory_;
  StagedSweeps& stages_;
  int unconfirmed_code_;
  int code_ = kDone;         ///< of the stage that ended early
  bool jams_alone_ = false;  ///< as the screen says
  LostRuns lost_ = {};       ///< in pilot and mixture; in confirmations lost runs count as failing
};

std::optional<StudyData> StageLeader::run_stage(const Stage& stage) {
  const std::string directory = path(stage.name);
  const Study study = stage_study(base_, stage);
  if (!stage.tolerances.empty()) begin_attempt(study, stage);
  code_ = stage.name == "mixture" ? sweep_grown(study, directory, stages_)
                                  : stages_.sweep(study, directory, stage.allowed_failures);
  if (code_ != kDone) return std::nullopt;
  auto runs = read_study_data(study_file_path(directory));
  runs.judged_again = is_judged_again(directory, runs.plan);
  if (stage.tolerances.empty() && too_many_lost(runs, directory)) {
    code_ = kSamplesFailed;
    return std::nullopt;
  }
  return runs;
}

bool StageLeader::too_many_lost(const StudyData& runs, const std::string& directory) {
  lost_ += count_lost(runs);
  const double share = lost_.minimum_share();
  if (lost_.lost == 0 || share <= base_.allowed_failure_share) return false;
  spdlog::error(
      "{} of {} runs so far failed, were censored or poisoned: with {:g} % confidence more than "
      "{:.3g} % do; the study allows {:.3g} %\n"
      "  remedy: look at one with `cagetol replay {} --sample ID`; samples/reason in study.h5 says "
      "what happened. With a larger allowed_failure_share the same command goes on",
      lost_.lost, lost_.runs, 100 * LostRuns::kConfidence, 100 * share,
      100 * base_.allowed_failure_share, directory);
  return true;
}

/// Makes the directory of an attempt, whole, with what its runs are to be judged by. Runs of an
/// earlier decision are taken where they are this attempt's, with what they were to be judged by.
void StageLeader::begin_attempt(const Study& study, const Stage& stage) const {
  if (fs::exists(path(stage.name))) return;
  const std::string made = path(stage.name + ".made");
  fs::remove_all(made);
  const auto earlier = adopt_any(study, made, sweeps_like(path(kEarlierFolder), stage.name + "-"));
  make_directory(made);
  if (earlier)
    fs::copy_file(*earlier / kJudgedByFile, fs::path(made) / kJudgedByFile);
  else
    replace_file(made + "/" + kJudgedByFile, stored_plan()->judgement.dump(1) + "\n");
  fs::rename(made, path(stage.name));
}

/// Moves attempts and their alternatives out of the way of those that the new limits ask for.
void StageLeader::set_attempts_aside(const CampaignPlan& plan) const {
  make_directory(path(kEarlierFolder));
  std::vector<fs::path> stages;
  for (const auto& entry : fs::directory_iterator(directory_))
    for (const char* prefix : {"confirm-", "assume-"})
      if (entry.path().filename().string().starts_with(prefix)) stages.push_back(entry.path());
  for (const fs::path& stage : stages) {
    std::string aside = path(fmt::format("{}/{}-{}", kEarlierFolder, stage.filename().string(),
                                         text_hash(plan.judgement.dump()).substr(0, 8)));
    while (fs::exists(aside)) aside += "+";
    fs::rename(stage, aside);
  }
}

void StageLeader::keep(const CampaignPlan& plan) const {
  replace_file(path("plan.json"), to_json(plan).dump(1) + "\n");
}

std::optional<CampaignPlan> StageLeader::stored_plan() const {
  const std::string file = path("plan.json");
  std::ifstream stream(file);
  if (!stream) return std::nullopt;
  try {
    return campaign_plan_of(nlohmann::ordered_json::parse(stream));
  } catch (const nlohmann::json::exception& error) {
    throw InputError({file, 0}, "", "", std::string("this is no plan: ") + error.what(),
                     "remove the file: it is made again from the pilot");
  }
}

/// The stored plan, brought to the budget of the study; made after the pilot, where there is none.
CampaignPlan StageLeader::plan(const StudyData& pilot) const {
  const CampaignSettings settings = campaign_settings(base_, jams_alone_);
  auto plan = stored_plan();
  try {
    if (!plan) {
      plan =
          plan_campaign(pilot, settings, static_cast<std::size_t>(base_.samples), stages_.ranks());
    } else if (plan->judgement != judgement_of(pilot.plan)) {
      const CampaignPlan again = with_judgement(*plan, pilot, settings);
      set_attempts_aside(*plan);
      plan = again;
      spdlog::info("limits, target or confidence have changed: attempts are decided again");
    } else if (!same_budget(plan->settings, settings)) {
      plan = with_settings(*plan, pilot, settings);
    }
  } catch (const Refused& refusal) {
    throw InputError({}, "recommend", "", refusal.what(),
                     "give a larger recommend.budget_samples or recommend.budget_h: the same "
                     "directory goes on with all of its runs. Or give fewer attempts or "
                     "candidates, or a lower target, in another directory");
  }
  keep(*plan);
  spdlog::info("{}", plan_text(pilot, *plan));
  return *plan;
}

int StageLeader::lead() {
  const auto screened = screen_stage(base_, path("screen"), stages_);
  const int* ended = std::get_if<int>(&screened);
  if (ended && *ended != kSamplesFailed) {
    if (*ended == kInterrupted) spdlog::warn(kInterruptedText);
    return *ended;
  }
  if (const auto* screen = std::get_if<Screen>(&screened)) jams_alone_ = screen->jams_alone;
  const Stage pilot{"pilot", static_cast<std::size_t>(base_.recommend.pilot_samples), {}};
  const Campaign campaign = run_campaign(
      pilot, [&](const StudyData& data) { return plan(data); },
      [&](const Stage& stage) { return run_stage(stage); },
      [&](const CampaignPlan& decided) { keep(decided); });
  for (const Attempt& attempt : campaign.attempts)
    spdlog::info("{} of {} runs meet all limits: {}", attempt.confirmation.meeting,
                 attempt.confirmation.runs,
                 attempt.confirmation.confirms() ? "confirmed"
                 : attempt.confirmation.passed
                     ? "judged again, by runs seen before; fresh ones: the same study with another "
                       "seed in another directory (the report has the command)"
                     : "not confirmed");
  if (campaign.end != CampaignEnd::interrupted)
    code_ = run_assumptions(base_, directory_, campaign, *stored_plan(), stages_);
  const auto confirmed = std::find_if(campaign.attempts.rbegin(), campaign.attempts.rend(),
                                      [](const Attempt& of) { return of.confirmation.confirms(); });
  if (code_ == kDone && campaign.end == CampaignEnd::confirmed && base_.rare.budget_samples > 0)
    code_ = rare_stage(base_, path("rare"), confirmed->recommendation.tolerances, stages_);
  if (code_ == kInterrupted) spdlog::warn(kInterruptedText);
  if (code_ != kDone || campaign.end == CampaignEnd::interrupted) return code_;
  if (campaign.end == CampaignEnd::confirmed) return kDone;
  if (campaign.end == CampaignEnd::budget_spent)
    spdlog::warn(
        "the runs left are too few for another attempt: the same command goes on with a larger "
        "recommend.budget_samples or recommend.budget_h");
  return unconfirmed_code_;
}

}  // namespace

int run_recommend(const std::function<Study()>& read, const MakePlan& make_plan,
                  const RecommendOptions& options) {
  const auto read_judgeable = [&] {
    Study study = read();
    require_limits_and_candidates(study);
    if (const auto faults = judgement_faults(study); !faults.empty()) throw faults.front();
    return study;
  };
  const auto lead = [&](const Study& base, StagedSweeps& stages) {
    return StageLeader(base, options, stages).lead();
  };
  return run_staged_study(read_judgeable, make_plan, options.directory, options.progress, lead);
}

}  // namespace cagetol
