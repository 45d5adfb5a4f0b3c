// cagetol rare STUDY -o DIR: how many cages in a million are bad, as far as runs can tell.
#include "mc/commands/rare_stages.hpp"
#include "mc/commands/stage_study.hpp"

namespace cagetol {

Chosen rare_command(CLI::App& command) {
  command.footer(
      "At the tolerances to which the study's laws belong. Cages that do not fit are known from\n"
      "geometry. A pilot of 50 cages that run twice, DIR/rare/pilot, chooses the route of each\n"
      "limit: counted in fresh runs, DIR/rare/tail; bounded by an extrapolation of their tail,\n"
      "blind to another kind of failure; or not to be stated, with what it would take. The same\n"
      "command resumes an interrupted run, also with a larger rare.budget_samples.\n\n"
      "Examples:\n  cagetol rare inputs/studies/nu205.toml -o out/nu205-rare\n"
      "  mpirun -n 2 cagetol rare inputs/studies/nu205.toml -o out/nu205-rare --set "
      "rare.target_ppm=1");
  return add_staged_study(command, "Directory of rare/: its sweeps, rare.json and figures/",
                          run_rare);
}

}  // namespace cagetol
