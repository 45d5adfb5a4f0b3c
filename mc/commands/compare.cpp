// cagetol compare OLD NEW: has any statistic of a study changed between two sweeps?
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/compare/comparison.hpp"
#include "analysis/report/report.hpp"
#include "analysis/study/study_file_error.hpp"
#include "mc/commands/command.hpp"
#include "mc/json_number.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

struct CompareArguments {
  std::string before, after;
  double error_rate = 0.01;
  bool json = false, all = false, despite_keys = false;
};

/// Unchanged statistics that the table shows without --all: those nearest to a change.
constexpr std::size_t kUnchangedShown = 5;

Json to_json(const Comparison& comparison) {
  Json statistics = Json::array();
  for (const StatisticChange& change : comparison.statistics)
    statistics.push_back({{"quantity", change.quantity},
                          {"unit", change.unit},
                          {"statistic", change.statistic},
                          {"old", json_number(change.before)},
                          {"new", json_number(change.after)},
                          {"p_value", change.p_value},
                          {"adjusted_p_value", change.adjusted_p_value},
                          {"changed", change.changed}});
  return {{"comparable", true},
          {"same", comparison.same()},
          {"same_cages", comparison.paired},
          {"error_rate", comparison.error_rate},
          {"multiplicity", "Holm"},
          {"notes", comparison.notes},
          {"statistics", statistics}};
}

std::string table_text(const Comparison& comparison, bool all) {
  std::string text = fmt::format("{:<36}{:<22}{:>13}{:>13}{:>12}\n", "quantity", "statistic", "old",
                                 "new", "adjusted p");
  std::size_t changed = 0, unchanged = 0;
  for (const StatisticChange& change : comparison.statistics) {
    changed += change.changed;
    if (!change.changed && ++unchanged > kUnchangedShown && !all) continue;
    text += fmt::format("{:<36}{:<22}{:>13.6g}{:>13.6g}{:>12.3g}{}\n", change.quantity,
                        change.statistic, change.before, change.after, change.adjusted_p_value,
                        change.changed ? "  CHANGED" : "");
  }
  if (!all && unchanged > kUnchangedShown)
    text += fmt::format("and {} more that have not changed (--all shows them)\n",
                        unchanged - kUnchangedShown);
  for (const std::string& note : comparison.notes) text += "note: " + note + "\n";
  return text + fmt::format(
                    "{} of {} statistics changed{}; the chance of any false alarm is at most {:g} "
                    "(Holm)\n",
                    changed, comparison.statistics.size(),
                    comparison.paired ? ", the same cages compared pair by pair" : "",
                    comparison.error_rate);
}

int not_comparable(const CompareArguments& options, const std::string& reason) {
  if (options.json) print(Json{{"comparable", false}, {"reason", reason}}.dump(2) + "\n");
  fmt::print(stderr, "cagetol: not comparable: {}\n", reason);
  return kBadInput;
}

int run_compare(const CompareArguments& options) {
  try {
    const Comparison comparison = compare_studies(read_study_data(study_file_in(options.before)),
                                                  read_study_data(study_file_in(options.after)),
                                                  options.error_rate, options.despite_keys);
    print(options.json ? to_json(comparison).dump(2) + "\n" : table_text(comparison, options.all));
    return comparison.same() ? kDone : kLimitsNotMet;
  } catch (const Refused& refusal) {
    return not_comparable(options, refusal.what());
  } catch (const StudyFileError& error) {
    return not_comparable(options, error.what());
  }
}

}  // namespace

void add_compare_command(CLI::App& app, Chosen& chosen) {
  auto* command = app.add_subcommand(
      "compare", "Say whether any statistic of a study has changed between two sweeps");
  command->footer(
      "Exit code 0: nothing changed, 1: something did, 2: not comparable, with the reason.\n\n"
      "Example:\n  cagetol compare out/yesterday out/today");
  auto options = std::make_shared<CompareArguments>();
  command->add_option("OLD", options->before, "Directory of the earlier sweep")->required();
  command->add_option("NEW", options->after, "Directory of the later sweep")->required();
  command
      ->add_option("--error-rate", options->error_rate,
                   "Probability of any false alarm when nothing has changed")
      ->check(CLI::Range(1e-9, 0.5))
      ->capture_default_str();
  command->add_flag("--all", options->all, "Show every statistic");
  command->add_flag("--despite-keys", options->despite_keys,
                    "Compare sweeps whose keys differ; the differences are noted");
  command->add_flag("--json", options->json, "Print every statistic as JSON");
  command->callback([options, &chosen] { chosen = [options] { return run_compare(*options); }; });
}

}  // namespace cagetol
