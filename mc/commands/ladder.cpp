// cagetol ladder SCENE|STUDY -o DIR: the least model that each quantity of interest needs.

#include <filesystem>
#include <memory>

#include "mc/commands/command.hpp"
#include "mc/commands/ladder_stages.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/file_write.hpp"

namespace cagetol {
namespace {

struct LadderArguments {
  std::string file, directory;
  std::vector<std::string> settings;
  LadderOptions ladder;
  bool refine = false, json = false;
  ProgressStyle progress = ProgressStyle::automatic;
};

void write_ladder(const ModelLadder& ladder, const LadderArguments& options) {
  const std::filesystem::path directory = options.directory;
  const std::string json = ladder_json(ladder).dump(1) + "\n";
  replace_file(directory / "ladder.json", json);
  const std::string figures = draw_beside(directory / "ladder.json");
  print(options.json ? json : ladder_text(ladder) + "ladder: " + figures + "\n");
}

int run_ladder(const LadderArguments& options) {
  return run_staged(make_sweep_plan, options.progress, [&](StagedSweeps& stages) {
    const Study study = read_study(options.file, options.settings);
    if (options.refine)
      require_dynamic(study.scene, "--refine", options.file, "integration to refine");
    else
      require_word_of_oil(study, options.file);
    const auto rungs = options.refine ? refining_rungs(study.scene) : climbing_rungs();
    const auto own = rungs_for(study.scene, rungs);
    auto climbed = climb(study, own, options.ladder, options.directory + "/rungs", stages);
    if (const int* code = std::get_if<int>(&climbed)) return *code;
    auto& ladder = std::get<ModelLadder>(climbed);
    ladder.refining = options.refine;
    write_ladder(ladder, options);
    return static_cast<int>(kDone);
  });
}

}  // namespace

Chosen ladder_command(CLI::App& command) {
  command.footer(
      "Rungs go from equilibria without motion over a rigid cage to a flexible one with all its\n"
      "modes, each in a sweep of its own, DIR/rungs/RUNG; the same command resumes it. A rung is\n"
      "adequate where its shift against the highest rung is within the budget with its whole 95 %\n"
      "interval, settled where no shift can matter to the study's limit because all runs are far\n"
      "on one side of it; where the samples do not tell, the answer is\n"
      "\"unresolved\". \"-\": the rung does not define the quantity.\n"
      "--refine compares the scene as it is with the same refined in one thing at a time, for the\n"
      "error budget in the report of the sweep whose directory holds it as ladder-refine.\n\n"
      "Examples:\n  cagetol ladder inputs/scenes/nu205.toml -o out/ladder\n"
      "  mpirun cagetol ladder inputs/studies/nu205.toml -o out/ladder-study --samples 200 "
      "--budget 1\n"
      "  cagetol ladder out/nu205/study.toml --refine -o out/nu205/ladder-refine");
  auto options = std::make_shared<LadderArguments>();
  command.add_option("FILE", options->file, "Scene or study file")->required();
  add_output_directory(command, options->directory,
                       "Directory of ladder.json, figures/ and rungs/");
  command.add_option("--samples", options->ladder.samples, "Runs on each rung")
      ->check(CLI::Range(2L, 1000000000L))
      ->capture_default_str();
  command
      .add_option("--budget", options->ladder.budget_share,
                  "Largest shift allowed, in standard errors of the study (of 1000 runs for a "
                  "scene)")
      ->check(CLI::Range(1e-6, 1e6))
      ->capture_default_str();
  command.add_flag("--refine", options->refine,
                   "Refine one thing at a time of the scene as it is: integrator, modes, slices, "
                   "mesh, window");
  command.add_flag("--json", options->json, "Print ladder.json on standard output");
  add_settings_option(command, options->settings);
  add_progress_option(command, options->progress);
  return [options] { return run_ladder(*options); };
}

}  // namespace cagetol
