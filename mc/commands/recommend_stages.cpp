#include "mc/commands/recommend_stages.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "analysis/study/study_file_error.hpp"
#include "analysis/tolerance/campaign.hpp"
#include "mc/commands/command.hpp"
#include "mc/h5.hpp"
#include "mc/signals.hpp"
#include "mc/sweep.hpp"
#include "src/input/input_error.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

constexpr double kLastWordsSeconds = 2;

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
    if (stage.bands.empty()) return;
    study.design = "random";
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
  if (study.design != "random" && study.design != "lhs" && study.design != "sobol")
    refuse("design", study.design, "this design does not sample tolerances",
           "use random, lhs or sobol");
  if (study.tolerance.target_yield >= 1)
    refuse("tolerance.target_yield", number_text(study.tolerance.target_yield),
           "a yield of 1 cannot be confirmed by any number of runs", "give less, such as 0.999");
}

void tell(const Team& team, const std::string& text) {
  for (int rank = 1; rank < team.size(); ++rank) team.send(rank, text);
}

/// Rank 0: decides and leads.
class StageLeader {
 public:
  StageLeader(const Launch& launch, const Study& base,
              const std::function<SweepPlan(const Study&)>& make_plan,
              const RecommendOptions& options, std::unique_ptr<Team>& team)
      : launch_(launch), base_(base), make_plan_(make_plan), options_(options), team_(team) {}

  int lead();

 private:
  std::string path(const std::string& name) const { return options_.directory + "/" + name; }
  bool complete(const Study& study, const std::string& directory) const;
  std::optional<StudyData> run_stage(const Stage& stage);
  CampaignPlan plan(const StudyData& pilot) const;

  const Launch& launch_;
  const Study& base_;
  const std::function<SweepPlan(const Study&)>& make_plan_;
  const RecommendOptions& options_;
  std::unique_ptr<Team>& team_;  ///< made with the first stage that has anything to run
  int code_ = kInterrupted;      ///< of the stage that ended early
};

/// Whether every sample of the stage is stored, by this build, with no more failures than allowed.
/// Anything doubtful is left to the sweep, which has the messages.
bool StageLeader::complete(const Study& study, const std::string& directory) const {
  if (!std::filesystem::exists(study_file_path(directory))) return false;
  try {
    const StudyFile file = read_study_file(study_file_path(directory));
    const auto samples = sample_count(study);
    if (file.study_hash != study.hash || file.build != build_id(build_info()) ||
        file.outcomes.size() != samples)
      return false;
    std::size_t failures = 0;
    for (const auto& [id, outcome] : file.outcomes) failures += is_failure(outcome.status);
    return static_cast<double>(failures) <=
           study.allowed_failure_share * static_cast<double>(samples);
  } catch (const H5Error&) {
    return false;
  }
}

std::optional<StudyData> StageLeader::run_stage(const Stage& stage) {
  const Study study = stage_study(base_, stage);
  const std::string directory = path(stage.name);
  if (!complete(study, directory)) {
    if (SignalWatch::draining()) return std::nullopt;
    spdlog::info("{}: {} runs in {}", stage.name, sample_count(study), directory);
    Sweep sweep(launch_, {.directory = directory, .progress = options_.progress});
    sweep.prepare([&] { return make_plan_(study); }, launch_.under_mpi && team_);
    if (!team_) team_ = std::make_unique<Team>(launch_);
    tell(*team_, directory + "\n" + study.resolved_toml);
    code_ = sweep.run(*team_);
    if (code_ != kDone) return std::nullopt;
    code_ = kInterrupted;
  }
  return read_study_data(study_file_path(directory));
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
      plan = plan_campaign(pilot, static_cast<std::size_t>(base_.samples), launch_.size);
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

/// The next stage from rank 0, "DIRECTORY\nresolved study"; empty at the end.
std::string next_stage(const Team& team) {
  while (true) {
    if (const auto message = team.receive()) return message->bytes;
    if (SignalWatch::stopping_for_s() > 2 * kLastWordsSeconds) ::_exit(kInterrupted);
    short_rest();
  }
}

void follow(const Launch& launch, const std::function<SweepPlan(const Study&)>& make_plan) {
  const Team team(launch);
  for (std::string text = next_stage(team); !text.empty(); text = next_stage(team)) {
    const auto line = text.find('\n');
    const std::string directory = text.substr(0, line);
    Sweep sweep(launch, {.directory = directory, .progress = ProgressStyle::off});
    sweep.prepare([&] { return make_plan(read_resolved_study(text.substr(line + 1), directory)); },
                  true);
    sweep.run(team);
  }
}

}  // namespace

int run_recommend(const std::function<Study()>& read,
                  const std::function<SweepPlan(const Study&)>& make_plan,
                  const RecommendOptions& options) {
  const Launch launch = launch_from_environment();
  const SignalWatch signals;
  if (launch.rank != 0) {
    follow(launch, make_plan);
    return kDone;
  }
  std::unique_ptr<Team> team;
  int code = kBadInput;
  try {
    const Study base = read();
    check_study(base);
    code = StageLeader(launch, base, make_plan, options, team).lead();
  } catch (const WriteError& problem) {
    fmt::print(stderr, "cagetol: {}\n", problem.what());
    code = problem.can_go_on() ? kInterrupted : kBadInput;
  } catch (const std::exception& problem) {
    fmt::print(stderr, "cagetol: {}\n", problem.what());
  }
  if (!team) team = std::make_unique<Team>(launch);  // the others wait for it
  tell(*team, "");
  return code;
}

}  // namespace cagetol
