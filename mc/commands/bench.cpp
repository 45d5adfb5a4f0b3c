// cagetol bench SCENE: what a simulated second costs, by integration method.
#include "mc/benchmark/bench.hpp"

#include <memory>
#include <nlohmann/json.hpp>

#include "mc/commands/command.hpp"
#include "mc/study/sample.hpp"

namespace cagetol {
namespace {

struct BenchArguments {
  std::string file;
  std::vector<std::string> settings;
  BenchOptions bench;
  bool json = false;
};

int run_bench(const BenchArguments& options) {
  const Study study = read_study(options.file, options.settings);
  require_dynamic(study.scene, "FILE", options.file, "integration to measure");
  const BenchResult result = bench(draw_sample(study, 0).scene, options.bench);
  print(options.json ? bench_json(result).dump(2) + "\n" : bench_text(result));
  return result.methods.front().status == Status::ok ? kDone : kSamplesFailed;
}

}  // namespace

Chosen bench_command(CLI::App& command) {
  command.footer(
      "Examples:\n  cagetol bench inputs/scenes/speed-z16.toml\n"
      "  cagetol bench inputs/scenes/speed-z16.toml --json --methods rodas3,rodasp --set "
      "load.radial_N=3000");
  auto options = std::make_shared<BenchArguments>();
  command.add_option("SCENE", options->file, "Scene file (or study: its first sample)")->required();
  command.add_flag("--json", options->json, "Print the measurements as JSON");
  add_methods_option(command, options->bench.methods);
  command.add_option("--repeats", options->bench.repeats, "Runs of each method; medians are given")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  add_settings_option(command, options->settings);
  return [options] { return run_bench(*options); };
}

}  // namespace cagetol
