// cagetol recommend STUDY -o DIR: the widest (or cheapest) tolerance that meets the target,
// confirmed by fresh runs.
#include <memory>

#include "analysis/report/report.hpp"
#include "mc/commands/bearing_facts.hpp"
#include "mc/commands/cage_peak.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/commands/recommend_stages.hpp"
#include "mc/commands/study_motion.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/ranks/team.hpp"
#include "mc/study/study.hpp"

namespace cagetol {
namespace {

struct RecommendArguments {
  std::string file;
  std::vector<std::string> settings;
  RecommendOptions stages;
};

int run_recommend(const RecommendArguments& options) {
  const SignalWatch signals;
  const int code =
      run_recommend(reading_study(options.file, options.settings), make_sweep_plan, options.stages);
  const bool decided = code == kDone || code == kLimitsNotMet;
  if (decided && launch_from_environment().rank == 0) {
    const auto sweep_directory = study_file_in(options.stages.directory).parent_path();
    update_cage_peak(sweep_directory);
    update_study_motion(sweep_directory);
    run_report(options.stages.directory, {.bearing = bearing_facts});
  }
  return code;
}

}  // namespace

Chosen recommend_command(CLI::App& command) {
  command.footer(
      "Stages: DIR/screen, DIR/pilot, DIR/mixture over all candidates, DIR/confirm-1 ... Each is\n"
      "a sweep. The same command resumes an interrupted run, also with a larger\n"
      "recommend.budget_samples or recommend.budget_h. Exit code 0: decided; with --exit-code 1\n"
      "where no tolerance is confirmed. recommend.assumption_samples, set at once or later,\n"
      "judges the verdict at both ends of every range of an [[assumption]].\n\n"
      "Examples:\n  cagetol recommend inputs/studies/nu205.toml -o out/nu205-drawing\n"
      "  mpirun cagetol recommend inputs/studies/nu205.toml -o out/nu205-drawing\n"
      "  cagetol recommend inputs/studies/nu205.toml -o out/night --set recommend.budget_h=8\n"
      "  cagetol recommend inputs/studies/nu205.toml -o out/nu205-drawing --set "
      "recommend.assumption_samples=auto");
  auto options = std::make_shared<RecommendArguments>();
  command.add_option("STUDY", options->file, "Study file")->required();
  add_output_directory(command, options->stages.directory,
                       "Directory of the results, one folder a stage");
  add_settings_option(command, options->settings);
  command.add_flag("--exit-code", options->stages.exit_code,
                   "End with 1 where no tolerance is confirmed");
  add_progress_option(command, options->stages.progress);
  return [options] { return run_recommend(*options); };
}

}  // namespace cagetol
