// The program: parses the command line, runs the command chosen, returns its exit code.
#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <cstdio>
#include <exception>
#include <sstream>

#include "mc/commands/command.hpp"
#include "mc/failure.hpp"
#include "mc/log.hpp"
#include "mc/page_faults.hpp"
#include "mc/process_limits.hpp"
#include "src/input/printable.hpp"

namespace {

constexpr const char* kExamples =
    "Exit codes: 0 done, 1 limits not met (compare: changed) where asked to judge, 2 bad input,\n"
    "3 samples failed beyond the allowed share, 70 a fault of the program, 75 interrupted: start\n"
    "the same command again to go on.\n\n"
    "Examples:\n"
    "  cagetol check inputs/studies/nu205.toml\n"
    "  cagetol simulate inputs/scenes/nu205.toml --json\n"
    "  cagetol sweep inputs/studies/nu205.toml -o out/nu205\n"
    "  cagetol recommend inputs/studies/nu205.toml -o out/nu205-drawing\n"
    "  cagetol replay out/nu205 --sample 17\n"
    "  cagetol animate out/nu205 --sample 17\n"
    "  cagetol cage inputs/scenes/nu205.toml\n"
    "  cagetol bench inputs/scenes/speed-z16.toml\n"
    "  cagetol chart inputs/scenes/speed-z16.toml -o out/chart\n"
    "  cagetol ladder inputs/scenes/nu205.toml -o out/ladder\n"
    "  cagetol stability -o out/stability\n"
    "  cagetol limits inputs/studies/nu205.toml -o out/nu205-limits\n"
    "  cagetol quantities pocket_force\n"
    "  cagetol scene NU208 > nu208.toml\n"
    "  cagetol --dump-default scene";

}  // namespace

int main(int argc, char** argv) try {
  using namespace cagetol;
  require_process_limits();
  avoid_page_faults();
  log_to_stderr();        // stdout is for results alone, whatever the command
  Eigen::initParallel();  // asks for the caches' sizes, which takes a virtual machine 60 us
  CLI::App app{
      "Monte Carlo tolerance sensitivity of cylindrical roller bearings with flexible cages",
      "cagetol"};
  app.footer(kExamples);
  app.require_subcommand(0, 1);
  Chosen chosen;
  add_check_command(app, chosen);
  add_simulate_command(app, chosen);
  add_sweep_command(app, chosen);
  add_recommend_command(app, chosen);
  add_replay_command(app, chosen);
  add_animate_command(app, chosen);
  add_report_command(app, chosen);
  add_cage_command(app, chosen);
  add_compare_command(app, chosen);
  add_bench_command(app, chosen);
  add_chart_command(app, chosen);
  add_ladder_command(app, chosen);
  add_stability_command(app, chosen);
  add_limits_command(app, chosen);
  add_quantities_command(app, chosen);
  add_scene_command(app, chosen);
  add_dump_default_option(app, chosen);
  add_version_option(app, chosen);
  add_manual_options(app, chosen);
  try {
    app.parse(argc, argv);
    if (chosen) return chosen();
    std::fputs(app.help().c_str(), stderr);
    return kBadInput;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error), kDone;
    std::ostringstream said;
    app.exit(error, said, said);
    std::fputs(printable(said.str(), LineBreaks::kept).c_str(), stderr);
    return kBadInput;
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "cagetol: %s\n",
               cagetol::printable(cagetol::ending_text(error), cagetol::LineBreaks::kept).c_str());
  return cagetol::exit_code_for(error);
}
