#include "mc/commands/recommend_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <fstream>

#include "analysis/study/refused.hpp"
#include "analysis/tolerance/campaign.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/ladder_stages.hpp"
#include "mc/forecast.hpp"
#include "mc/sweep_directory.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

/// Every stage has random numbers of its own; all follow from the study's seed.
long stage_seed(long seed, const std::string& stage) {
  return static_cast<long>(std::stoull(text_hash(fmt::format("{} {}", seed, stage)), nullptr, 16) >>
                           11);
}

Study stage_study(const Study& base, const Stage& stage) {
  return changed_study(base, [&](Study& study) {
    study.name += ", " + stage.name;
    study.seed = stage_seed(base.seed, stage.name);
    study.samples = static_cast<long>(stage.rows);
    study.allowed_failure_share = 1;  // judged over the campaign, which may go on with another
    if (stage.bands.empty()) return;
    study.design = DesignKind::random;
    study.cages_per_lot = 1;
    study.extra_replicates = 0;
    for (std::size_t d = 0; d < stage.bands.size(); ++d) {
      const RecommendedBand& band = stage.bands[d];
      auto& dimension = study.tolerance.dimensions[d];
      dimension.cost.reset();
      dimension.candidates = {band.grade.empty() ? number_text(band.band_mm) : band.grade};
    }
  });
}

void check_study(const Study& study) {
  const auto refuse = [](const char* key, const std::string& value, const char* why,
                         const char* remedy) { throw InputError({}, key, value, why, remedy); };
  if (study.limits.empty())
    refuse("limit", "", "the study has no limits: there is nothing to judge a tolerance by",
           "add [[limit]] with quantity, max, source and cage_revolutions");
  if (study.candidates.empty())
    refuse("tolerance.dimension", "", "the study has no candidate tolerances",
           "add [[tolerance.dimension]] with key, band_mm and candidates");
  if (study.design != DesignKind::random && study.design != DesignKind::lhs &&
      study.design != DesignKind::sobol)
    refuse("design", design_name(study.design), "this design does not sample tolerances",
           "use random, lhs or sobol");
  if (study.tolerance.target_yield >= 1)
    refuse("tolerance.target_yield", number_text(study.tolerance.target_yield),
           "a yield of 1 cannot be confirmed by any number of runs", "give less, such as 0.999");
}

/// Rank 0: decides and leads.
class StageLeader {
 public:
  StageLeader(const Study& base, const std::string& directory, StagedSweeps& stages)
      : base_(base), directory_(directory), stages_(stages) {}

  int lead();

 private:
  std::string path(const std::string& name) const { return directory_ + "/" + name; }
  std::optional<StudyData> run_stage(const Stage& stage);
  CampaignPlan plan(const StudyData& pilot) const;
  bool too_many_lost(const StudyData& runs, const std::string& directory);

  const Study& base_;
  std::string directory_;
  StagedSweeps& stages_;
  int code_ = kDone;    ///< of the stage that ended early
  LostRuns lost_ = {};  ///< in pilot and mixture; in confirmations lost runs count as failing
};

std::optional<StudyData> StageLeader::run_stage(const Stage& stage) {
  const std::string directory = path(stage.name);
  code_ = stages_.sweep(stage_study(base_, stage), directory);
  if (code_ != kDone) return std::nullopt;
  auto runs = read_study_data(study_file_path(directory));
  if (stage.bands.empty() && too_many_lost(runs, directory)) {
    code_ = kSamplesFailed;
    return std::nullopt;
  }
  return runs;
}

bool StageLeader::too_many_lost(const StudyData& runs, const std::string& directory) {
  lost_ += count_lost(runs);
  const double share = lost_.least_share();
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

/// The stored plan; made after the pilot, where there is none yet.
CampaignPlan StageLeader::plan(const StudyData& pilot) const {
  const std::string file = path("plan.json");
  CampaignPlan plan;
  if (std::ifstream stream(file); stream) {
    try {
      plan = campaign_plan_of(nlohmann::ordered_json::parse(stream));
    } catch (const nlohmann::json::exception& error) {
      throw InputError({file, 0}, "", "", std::string("this is no plan: ") + error.what(),
                       "remove the file: it is made again from the pilot");
    }
  } else {
    try {
      plan = plan_campaign(pilot, static_cast<std::size_t>(base_.samples), stages_.ranks());
    } catch (const Refused& refusal) {
      throw InputError({}, "recommend", "", refusal.what(),
                       "give a larger recommend.budget_samples or recommend.budget_h, fewer "
                       "attempts or candidates, or a lower target");
    }
    replace_file(file, to_json(plan).dump(1) + "\n");
  }
  spdlog::info("{}", plan_text(pilot, plan));
  return plan;
}

int StageLeader::lead() {
  const Stage pilot{"pilot", static_cast<std::size_t>(base_.recommend.pilot_samples), {}};
  const Campaign campaign = run_campaign(
      pilot, [&](const StudyData& data) { return plan(data); },
      [&](const Stage& stage) { return run_stage(stage); });
  for (const Attempt& attempt : campaign.attempts)
    spdlog::info("{} of {} runs meet all limits: {}", attempt.confirmation.meeting,
                 attempt.confirmation.runs,
                 attempt.confirmation.passed ? "confirmed" : "not confirmed");
  switch (campaign.end) {
    case CampaignEnd::interrupted:
      if (code_ == kInterrupted) spdlog::warn("interrupted: start the same command again to go on");
      return code_;
    case CampaignEnd::confirmed:
      return kDone;
    case CampaignEnd::no_candidate:
    case CampaignEnd::not_confirmed:
      break;
  }
  return kLimitsNotMet;
}

}  // namespace

int run_recommend(const std::function<Study()>& read, const MakePlan& make_plan,
                  const RecommendOptions& options) {
  return run_staged(make_plan, options.progress, [&](StagedSweeps& stages) {
    const Study given = read();
    check_study(given);
    require_memory(forecast_sweep(given), ranks_on_this_machine());
    require_disk(forecast_sweep(given), options.directory);
    const auto base = with_fidelity(given, options.directory, stages);
    if (const int* code = std::get_if<int>(&base)) return *code;
    return StageLeader(std::get<Study>(base), options.directory, stages).lead();
  });
}

}  // namespace cagetol
