// cagetol replay DIR --sample ID: one sample of a sweep once more, compared to the bit with what is
// stored.
#include "mc/sweep/replay.hpp"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "mc/commands/command.hpp"
#include "mc/commands/outcome_text.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/commands/recorded_run.hpp"
#include "mc/host/log.hpp"

namespace cagetol {
namespace {

struct ReplayArguments {
  std::string directory, history;
  std::uint64_t sample = 0;
  bool json = false;
};

std::string verdict(const StoredSample& stored, const std::vector<std::string>& differences) {
  if (!stored.stored) return "study.h5 has no outcome of this sample yet: nothing to compare";
  if (differences.empty()) return "reproduced to the bit";
  std::string text = "NOT reproduced; stored and now:";
  for (const std::string& difference : differences) text += "\n  " + difference;
  return text;
}

std::string json_text(const StoredSample& stored, const Outcome& outcome,
                      const std::vector<std::string>& differences) {
  nlohmann::ordered_json json = {{"sample", stored.sample.id}};
  json["reproduced"] =
      stored.stored ? nlohmann::ordered_json(differences.empty()) : nlohmann::ordered_json(nullptr);
  json["differences"] = differences;
  json["stored_build"] = stored.stored_build;
  json["notes"] = stored.notes;
  json.update(outcome_json(outcome));
  return json.dump(2) + "\n";
}

int run_replay(const ReplayArguments& options) {
  const StoredSample stored = read_stored_sample(options.directory, options.sample);
  for (const std::string& note : stored.notes) say("cagetol: {}\n", note);
  if (stored.stored && stored.stored->status == Status::poisoned)
    say("cagetol: this sample ended its process during the sweep and may do so now\n");

  const Outcome again = recorded_run(stored.study, stored.sample, options.history);
  const auto differences =
      stored.stored
          ? outcome_differences(*stored.stored, make_stored_outcome(options.sample, again, 0, 0))
          : std::vector<std::string>{};
  if (options.json)
    print(json_text(stored, again, differences));
  else
    print(fmt::format("{}{}\n", outcome_table(again), verdict(stored, differences)));
  return differences.empty() ? kDone : kLimitsNotMet;
}

}  // namespace

Chosen replay_command(CLI::App& command) {
  command.footer(
      "Needs DIR/study.h5 alone. Exit code 0 when reproduced, 1 when not.\n\n"
      "Examples:\n  cagetol replay out/nu205 --sample 17\n"
      "  cagetol replay out/nu205 --sample 17 -o out/run17.h5");
  auto options = std::make_shared<ReplayArguments>();
  add_result_directory(command, "DIR", options->directory, "Directory of a sweep");
  command.add_option("--sample", options->sample, "Id of the sample")
      ->required()
      ->check(CLI::Range(0L, kMostSamples));
  command.add_flag("--json", options->json, "Print verdict, quantities and run as JSON");
  add_history_option(command, options->history);
  return [options] { return run_replay(*options); };
}

}  // namespace cagetol
