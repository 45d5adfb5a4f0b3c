// cagetol sweep STUDY -o DIR: every sample of a study, serial or under mpirun.
#include "mc/sweep.hpp"

#include <spdlog/spdlog.h>

#include <memory>

#include "mc/commands/command.hpp"
#include "mc/log.hpp"
#include "mc/study.hpp"
#include "mc/team.hpp"

namespace cagetol {
namespace {

struct SweepArguments {
  std::string file;
  std::vector<std::string> settings;
  SweepOptions sweep;
};

int run_sweep(const SweepArguments& options) {
  log_to_stderr();
  return run_sweep(
      [&] {
        const Study study = read_study(options.file, options.settings);
        if (launch_from_environment().rank == 0)
          for (const std::string& note : study_notes(study)) spdlog::warn("{}", note);
        return make_sweep_plan(study);
      },
      options.sweep);
}

}  // namespace

void add_sweep_command(CLI::App& app, Chosen& chosen) {
  auto* command = app.add_subcommand(
      "sweep", "Run every sample of a study; started again, it goes on where it was interrupted");
  command->footer(
      "SIGUSR1 drains: samples in flight finish, everything is written, exit code 75.\n\n"
      "Examples:\n  cagetol sweep inputs/studies/nu205.toml -o out/nu205\n"
      "  mpirun cagetol sweep inputs/studies/nu205.toml -o out/nu205\n"
      "  cagetol sweep inputs/studies/nu205.toml -o out/small --set samples=16");
  auto options = std::make_shared<SweepArguments>();
  command->add_option("STUDY", options->file, "Study file")->required();
  command
      ->add_option("-o,--output", options->sweep.directory,
                   "Directory of the results: study.h5 and the journals")
      ->required();
  add_settings_option(*command, options->settings);
  add_progress_option(*command, options->sweep.progress);
  command->callback([options, &chosen] { chosen = [options] { return run_sweep(*options); }; });
}

}  // namespace cagetol
