#include "mc/commands/stage_study.hpp"

#include <fmt/format.h>

#include <memory>

#include "mc/commands/judgeable.hpp"
#include "mc/commands/ladder_stages.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/run/forecast.hpp"
#include "mc/sweep/adopted_runs.hpp"
#include "mc/sweep/sweep_directory.hpp"
#include "src/input/unit.hpp"

namespace cagetol {
namespace {

/// Every stage has random numbers of its own; all follow from the study's seed.
long stage_seed(long seed, const std::string& stage) {
  return static_cast<long>(std::stoull(text_hash(fmt::format("{} {}", seed, stage)), nullptr, 16) >>
                           11);
}

}  // namespace

Study stage_study(const Study& base, const Stage& stage) {
  return changed_study(base, [&](Study& study) {
    study.name += ", " + stage.name;
    study.seed = stage_seed(base.seed, stage.name);
    study.samples = static_cast<long>(stage.rows);
    study.redraw_jams = true;
    study.allowed_failure_share = 1;  // judged over the campaign, which may go on with another
    // A budget may be raised: stages and their runs stay as they are.
    study.recommend.pilot_samples = RecommendPlan{}.pilot_samples;
    study.recommend.confirm_samples = study.recommend.budget_samples = 0;
    study.recommend.budget_time = study.recommend.assumption_samples = 0;
    study.screen = {};
    study.map = {};
    study.rare = {};
    // So may ranges, of which a stage knows one value: DIR/assumptions.json holds them.
    for (Assumption& assumption : study.scene.assumptions)
      assumption = {assumption.key, assumption.note};
    if (stage.tolerances.empty()) return;
    study.recommend.attempts = static_cast<long>(stage.error_shares);
    study.design = DesignKind::random;
    study.cages_per_lot = 1;
    study.extra_replicates = 0;
    for (std::size_t d = 0; d < stage.tolerances.size(); ++d) {
      const RecommendedTolerance& tolerance = stage.tolerances[d];
      auto& dimension = study.tolerance.dimensions[d];
      dimension.cost.clear();
      dimension.candidates = {tolerance.grade.empty() ? number_text(tolerance.tolerance_width_mm)
                                                      : tolerance.grade};
      if (tolerance.centre) dimension.centres = {*tolerance.centre};
    }
  });
}

int sweep_grown(const Study& study, const std::string& directory, StagedSweeps& stages) {
  const long rows = stored_rows(directory);
  if (rows > 0 && rows < study.samples) {
    const Study smaller = changed_study(study, [&](Study& stored) { stored.samples = rows; });
    if (const int code = stages.sweep(smaller, directory)) return code;
    grow_directory(study, directory);
  }
  return stages.sweep(study, directory);
}

int run_staged_study(const std::function<Study()>& read, const MakePlan& make_plan,
                     const std::string& directory, ProgressStyle progress, const LeadStages& lead) {
  return run_staged(make_plan, progress, [&](StagedSweeps& stages) -> int {
    const Study given = read();
    require_limits_and_candidates(given);
    require_no_other(directory, "journal", "a sweep");
    require_memory(forecast_sweep(given), ranks_on_this_machine());
    require_disk(forecast_sweep(given), directory);
    const auto base = with_fidelity(given, directory, stages);
    if (const int* code = std::get_if<int>(&base)) return *code;
    return lead(std::get<Study>(base), stages);
  });
}

Chosen add_staged_study(CLI::App& command, const std::string& directory_text,
                        int (*run)(const std::function<Study()>&, const MakePlan&,
                                   const std::string&, ProgressStyle)) {
  struct Arguments {
    std::string file, directory;
    std::vector<std::string> settings;
    ProgressStyle progress = ProgressStyle::automatic;
  };
  auto options = std::make_shared<Arguments>();
  command.add_option("STUDY", options->file, "Study file")->required();
  add_output_directory(command, options->directory, directory_text);
  add_settings_option(command, options->settings);
  add_progress_option(command, options->progress);
  return [options, run] {
    return run(reading_study(options->file, options->settings), make_sweep_plan, options->directory,
               options->progress);
  };
}

}  // namespace cagetol
