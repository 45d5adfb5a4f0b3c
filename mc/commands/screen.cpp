// cagetol screen STUDY -o DIR: which tolerance moves which limited quantity, from a few dozen runs.
#include "mc/commands/screen_stages.hpp"
#include "mc/commands/stage_study.hpp"

namespace cagetol {
Chosen screen_command(CLI::App& command) {
  command.footer(
      "Says of each limit how far 0.01 mm of each tolerance moves its quantity, what the start\n"
      "alone does, at which tolerance width the limit is reached or a jam comes first, and which\n"
      "question is worth a campaign. screen.budget_samples runs in DIR/screen; the same command\n"
      "resumes an interrupted run.\n\n"
      "Examples:\n  cagetol screen inputs/studies/nu205.toml -o out/nu205-screen\n"
      "  mpirun -n 2 cagetol screen inputs/studies/nu205.toml -o out/nu205-screen --set "
      "screen.budget_samples=60");
  return add_staged_study(command, "Directory of screen/: its sweep, screen.json and figures/",
                          run_screen);
}

}  // namespace cagetol
