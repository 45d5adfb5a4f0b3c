// cagetol screen STUDY -o DIR: which tolerance moves which limited quantity, from a few dozen runs.
#include <memory>

#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/commands/screen_stages.hpp"
#include "mc/study/study.hpp"

namespace cagetol {
namespace {

struct ScreenArguments {
  std::string file, directory;
  std::vector<std::string> settings;
  ProgressStyle progress = ProgressStyle::automatic;
};

}  // namespace

Chosen screen_command(CLI::App& command) {
  command.footer(
      "Says of each limit how far 0.01 mm of each tolerance moves its quantity, what the start\n"
      "alone does, at which tolerance width the limit is reached or a jam comes first, and which\n"
      "question is worth a campaign. screen.budget_samples runs in DIR/screen; the same command\n"
      "resumes an interrupted run.\n\n"
      "Examples:\n  cagetol screen inputs/studies/nu205.toml -o out/nu205-screen\n"
      "  mpirun -n 2 cagetol screen inputs/studies/nu205.toml -o out/nu205-screen --set "
      "screen.budget_samples=60");
  auto options = std::make_shared<ScreenArguments>();
  command.add_option("STUDY", options->file, "Study file")->required();
  add_output_directory(command, options->directory,
                       "Directory of screen/: its sweep, screen.json and figures/");
  add_settings_option(command, options->settings);
  add_progress_option(command, options->progress);
  return [options] {
    return run_screen(reading_study(options->file, options->settings), make_sweep_plan,
                      options->directory, options->progress);
  };
}

}  // namespace cagetol
