// cagetol map STUDY --over KEY=... --over KEY=... -o DIR: the widest tolerance over two keys of an
// operating point, and what decides there.
#include <memory>

#include "mc/commands/command.hpp"
#include "mc/commands/map_stages.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/study/study.hpp"

namespace cagetol {
namespace {

struct MapArguments {
  std::string file;
  std::vector<std::string> settings;
  MapOptions map;
};

}  // namespace

Chosen map_command(CLI::App& command) {
  command.footer(
      "A screen in each cell of the grid: the widest candidate that meets the target, what ends\n"
      "it - jams or a limit - and what comes next. map.budget_samples runs a cell in DIR/map, and\n"
      "map.border_samples more where a neighbour has another answer; the same command resumes an\n"
      "interrupted run. KEY is one of load, speed, oil or heat; the first lies upwards, the "
      "second\nacross. A..B:N are N values, with :log in equal ratios. Limits must hold in every "
      "cell.\n\n"
      "Examples:\n  cagetol map inputs/studies/nu205-map.toml --over "
      "load.radial_N=100..10000:6:log "
      "--over speed.inner_rpm=1000..14000:6 -o out/nu205-map\n"
      "  mpirun -n 2 cagetol map inputs/studies/spindle-map.toml --over "
      "load.radial_N=500,1500,5000 --over speed.inner_rpm=5000..15000:3 -o out/spindle-map");
  auto options = std::make_shared<MapArguments>();
  command.add_option("STUDY", options->file, "Study file")->required();
  command.add_option("--over", options->map.over, "A key and its values; twice")
      ->type_name("KEY=VALUES")
      ->required()
      ->allow_extra_args(false);
  add_output_directory(command, options->map.directory,
                       "Directory of map/: its cells, map.html, map.json, map.csv and figures/");
  command.add_flag("--pdf", options->map.pdf, "Write map.pdf, too (needs weasyprint)");
  add_settings_option(command, options->settings);
  add_progress_option(command, options->map.progress);
  return [options] {
    return run_map(reading_study(options->file, options->settings), make_sweep_plan, options->map);
  };
}

}  // namespace cagetol
