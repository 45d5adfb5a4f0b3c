// cagetol chart SCENE -o DIR: error against cost of every integration method and tolerance.
#include "mc/benchmark/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/log.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

struct ChartArguments {
  std::string file, directory;
  std::vector<std::string> settings;
  ChartOptions chart;
  double horizon_ms = kAuto;
};

int run_chart(const ChartArguments& options) {
  const Study study = read_study(options.file, options.settings);
  require_dynamic(study.scene, "FILE", options.file, "integration to measure");
  if (options.chart.rungs && options.chart.replicas < 2)
    throw InputError({}, "--rungs", fmt::format("--replicas {}", options.chart.replicas),
                     "a rung is compared by the means of its replicas",
                     "give --replicas 2 or more");
  make_directory(options.directory);
  ChartOptions wanted = options.chart;
  wanted.horizon = 1e-3 * options.horizon_ms;
  const Chart chart = make_chart(study, wanted, [](const std::string& what) { say("{}\n", what); });
  const std::filesystem::path directory = options.directory;
  replace_file(directory / "chart.json", chart_json(chart).dump(1) + "\n");
  print(chart_text(chart) + "chart: " + draw_beside(directory / "chart.json") + "\n");
  return kDone;
}

}  // namespace

Chosen chart_command(CLI::App& command) {
  command.footer(
      "Short horizon: trajectories against a tight run of a method of another kind. Whole window:\n"
      "bias of every quantity of interest over replicas with other cage offsets.\n\n"
      "Examples:\n  cagetol chart inputs/scenes/speed-z16.toml -o out/chart\n"
      "  cagetol chart inputs/scenes/speed-z16-skew.toml -o out/lively --methods rodas3,cvode-bdf "
      "--replicas 100\n"
      "  cagetol chart inputs/scenes/nu205.toml -o out/models --methods rodas3 --rungs");
  auto options = std::make_shared<ChartArguments>();
  command.add_option("SCENE", options->file, "Scene file (or study: its first row)")->required();
  add_output_directory(command, options->directory, "Directory of chart.json and figures/");
  add_methods_option(command, options->chart.methods);
  command
      .add_option("--replicas", options->chart.replicas,
                  "Runs of each setting over the scene's window; 0: trajectories only")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command.add_flag("--rungs", options->chart.rungs,
                   "Run the replicas on each rung of the model ladder, too (`cagetol ladder`)");
  command
      .add_option("--horizon-ms", options->horizon_ms,
                  "Length of the trajectories; the time between two rollers that pass if absent")
      ->check(CLI::Range(1e-3, 1e3));
  command.add_option("--starts", options->chart.starts, "Trajectories of each setting")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  options->chart.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  command.add_option("--threads", options->chart.threads, "Replicas at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  add_settings_option(command, options->settings);
  return [options] { return run_chart(*options); };
}

}  // namespace cagetol
