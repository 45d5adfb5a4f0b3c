// cagetol sweep STUDY -o DIR: every sample of a study, serial or under mpirun.
#include "mc/sweep/sweep.hpp"

#include <spdlog/spdlog.h>

#include <exception>
#include <memory>

#include "mc/commands/cage_peak.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/judgeable.hpp"
#include "mc/commands/ladder_stages.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/commands/study_motion.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/ranks/team.hpp"
#include "mc/run/forecast.hpp"
#include "mc/study/study.hpp"
#include "mc/sweep/adopted_runs.hpp"

namespace cagetol {
namespace {

struct SweepArguments {
  std::string file, measured;
  std::vector<std::string> settings;
  SweepOptions sweep;
};

Study read_with_notes(const SweepArguments& options) {
  Study study = options.measured.empty()
                    ? read_study(options.file, options.settings)
                    : read_measured_study(options.file, options.settings, options.measured);
  if (launch_from_environment().rank == 0) {
    log_notes(study, sweep_notes(study));
    for (const InputError& fault : judgement_faults(study)) spdlog::warn("{}", fault.what());
  }
  return study;
}

/// Whether a pilot chooses the model before the sweep.
bool is_staged(const Study& study) {
  return study.fidelity == "auto" && study.fidelity_decision.rung.empty();
}

int run_stages(const Study& given, const std::string& directory, StagedSweeps& stages) {
  require_memory(forecast_sweep(given), ranks_on_this_machine());
  require_disk(forecast_sweep(given), directory);
  const auto climbed = with_fidelity(given, directory, stages);
  if (const int* code = std::get_if<int>(&climbed)) return *code;
  const Study& study = std::get<Study>(climbed);
  if (study.resolved_toml != given.resolved_toml) {
    const std::size_t adopted = adopt_runs(
        study, directory, fidelity_folder(directory) + "/" + study.fidelity_decision.rung);
    if (adopted > 0) spdlog::info("{} runs of the pilot are the study's own", adopted);
  }
  return stages.sweep(study, directory);
}

/// All sweeps of the study. A study that cannot be read becomes the problem of a sweep, which makes
/// all ranks end and says it once.
int run_sweeps(const SweepArguments& options) {
  Study study;
  std::exception_ptr unread;
  try {
    study = read_with_notes(options);
  } catch (const std::exception&) {
    unread = std::current_exception();
  }
  if (is_staged(study))
    return run_staged(make_sweep_plan, options.sweep.progress, [&](StagedSweeps& stages) {
      return run_stages(study, options.sweep.directory, stages);
    });
  const auto make_plan = [&] {
    if (unread) std::rethrow_exception(unread);
    return make_sweep_plan(study);
  };
  return run_sweep(make_plan, options.sweep);
}

int run_sweep(const SweepArguments& options) {
  const SignalWatch signals;  // before a large study is read
  const int code = run_sweeps(options);
  const bool complete = code == kDone || code == kSamplesFailed;
  if (complete && launch_from_environment().rank == 0) {
    update_cage_peak(options.sweep.directory);
    update_study_motion(options.sweep.directory);
  }
  return code;
}

}  // namespace

Chosen sweep_command(CLI::App& command) {
  command.footer(
      "With fidelity = \"auto\" in the study a pilot in DIR/fidelity chooses the model first.\n"
      "SIGUSR1 ends the sweep gently: running samples finish and are stored, exit code 75.\n\n"
      "Examples:\n  cagetol sweep inputs/studies/nu205.toml -o out/nu205\n"
      "  mpirun cagetol sweep inputs/studies/nu205.toml -o out/nu205\n"
      "  cagetol sweep inputs/studies/nu205.toml -o out/small --set samples=16");
  auto options = std::make_shared<SweepArguments>();
  command.add_option("STUDY", options->file, "Study file")->required();
  add_output_directory(command, options->sweep.directory,
                       "Directory of the results: study.h5 and the journals");
  command.add_option("--measured", options->measured,
                     "CSV file of measured cages that run one after the other, each as often as "
                     "`samples` allows: which of them is at risk, and why");
  add_settings_option(command, options->settings);
  add_progress_option(command, options->sweep.progress);
  return [options] { return run_sweep(*options); };
}

}  // namespace cagetol
