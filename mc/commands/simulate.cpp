// cagetol simulate SCENE: one bearing, its quantities of interest as a table or as JSON.
#include <fmt/format.h>

#include <memory>

#include "analysis/study/estimate.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/operating_text.hpp"
#include "mc/commands/outcome_text.hpp"
#include "mc/commands/recorded_run.hpp"
#include "mc/study/sample.hpp"
#include "mc/study/study.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/quantity_table.hpp"

namespace cagetol {
namespace {

struct SimulateArguments {
  std::string file, history;
  std::vector<std::string> settings;
  std::uint64_t sample = 0;
  bool json = false;
};

std::string table_text(const Study& study, const Scene& scene, const Outcome& outcome,
                       std::uint64_t id) {
  std::string text =
      fmt::format("scene {}, sample {} of {}: {}{}\n", study.scene.name, id, sample_count(study),
                  status_name(outcome.status), outcome.reason.empty() ? "" : ", " + outcome.reason);
  for (const std::string& note : model_notes(study)) text += "note: " + note + "\n";
  return text + operating_table(scene) + outcome_table(outcome);
}

std::string json_text(const Scene& scene, const Outcome& outcome) {
  nlohmann::ordered_json json = outcome_json(outcome);
  const auto slip = static_cast<std::size_t>(quantity_index("cage_slip_ratio"));
  json["operating_point"] = operating_json(
      scene, slip < outcome.quantities.size() ? outcome.quantities[slip] : kUndefined);
  return json.dump(2) + "\n";
}

// A jam is an outcome of the bearing; the others are failures of the run.
int exit_code(Status status) {
  if (status == Status::ok || status == Status::jammed) return kDone;
  return status == Status::not_run ? kInterrupted : kSamplesFailed;
}

int run_simulate(const SimulateArguments& options) {
  const Study study = read_study(options.file, options.settings);
  if (options.sample >= sample_count(study))
    throw InputError({}, "--sample", std::to_string(options.sample),
                     fmt::format("the study has the samples 0 to {}", sample_count(study) - 1),
                     "choose one of them, or ask for more with --set samples=...");
  const Sample sample = draw_sample(study, options.sample);
  const Outcome outcome = recorded_run(study, sample, options.history);
  print(options.json ? json_text(sample.scene, outcome)
                     : table_text(study, sample.scene, outcome, options.sample));
  return exit_code(outcome.status);
}

}  // namespace

Chosen simulate_command(CLI::App& command) {
  command.footer(
      "Examples:\n  cagetol simulate inputs/scenes/nu205.toml --json\n"
      "  cagetol simulate inputs/scenes/speed-z16.toml --set load.radial_N=300 -o out/run.h5\n"
      "  cagetol simulate inputs/studies/nu205.toml --sample 17");
  auto options = std::make_shared<SimulateArguments>();
  command.add_option("SCENE", options->file, "Scene or study file")->required();
  command.add_flag("--json", options->json, "Print status, quantities and run as JSON");
  add_history_option(command, options->history);
  command.add_option("--sample", options->sample, "Sample of the study to run")
      ->check(CLI::Range(0L, kMostSamples))
      ->capture_default_str();
  add_settings_option(command, options->settings);
  return [options] { return run_simulate(*options); };
}

}  // namespace cagetol
