// cagetol stability -o DIR: every integration method on the scenes in which methods fail.
#include "mc/benchmark/stability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/file_write.hpp"
#include "mc/host/log.hpp"
#include "mc/study_file/shipped_file.hpp"

namespace cagetol {
namespace {

struct StabilityArguments {
  std::string directory, suite = shipped_file("inputs/stability.toml").string();
  std::vector<IntegrationMethod> methods;
  bool fast = false;
  int threads = 1;
};

int run_stability(const StabilityArguments& options) {
  std::vector<SuiteScene> suite = read_suite(options.suite);
  if (options.fast) std::erase_if(suite, [](const SuiteScene& scene) { return !scene.fast; });
  make_directory(options.directory);
  std::size_t done = 0;
  const auto tell = [&](const SuiteRow& row) {
    std::map<std::string, int> verdicts;
    for (const auto& [method, cell] : row.cells) ++verdicts[soundness_name(cell.soundness)];
    std::string text;
    for (const auto& [verdict, count] : verdicts)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, verdict);
    say("{}/{} {}: {}\n", ++done, suite.size(), row.scene, text);
  };
  const StabilityMap map = run_stability(suite, options.methods, options.threads, tell);
  const std::filesystem::path directory = options.directory;
  replace_file(directory / "stability.json", stability_json(map).dump(1) + "\n");
  print(stability_text(map) + "map: " + draw_beside(directory / "stability.json") + "\n");
  return is_sound(map) ? kDone : kLimitsNotMet;
}

}  // namespace

Chosen stability_command(CLI::App& command) {
  command.footer(
      "Ends with 1 where a method is silently wrong or the default method is not right.\n"
      "Example:\n  cagetol stability -o out/stability --fast --methods rodas3,cvode-bdf");
  auto options = std::make_shared<StabilityArguments>();
  add_output_directory(command, options->directory, "Directory of stability.json and figures/");
  add_methods_option(command, options->methods);
  command.add_flag("--fast", options->fast, "Only the scenes marked fast");
  command.add_option("--suite", options->suite, "Suite file: the scenes")->capture_default_str();
  options->threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  command.add_option("--threads", options->threads, "Runs at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  return [options] { return run_stability(*options); };
}

}  // namespace cagetol
