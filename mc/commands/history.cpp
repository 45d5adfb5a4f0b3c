// cagetol history DIR...: yields and limited quantities of studies that are run again and again,
// and what has changed from each to the next.
#include <fmt/format.h>

#include <memory>
#include <optional>

#include "analysis/compare/comparison.hpp"
#include "analysis/report/report.hpp"
#include "analysis/statistics/summary.hpp"
#include "analysis/statistics/yield.hpp"
#include "analysis/study/refused.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/json_number.hpp"

namespace cagetol {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kConfidence = 0.95;  ///< of means, and of each bound of a yield
/// Changed statistics of a study that the table names.
constexpr std::size_t kChangesShown = 3;

struct HistoryArguments {
  std::vector<std::string> directories;
  std::string output;
  double error_rate = 0.01;
};

Json quantities_json(const StudyData& runs, const Resampling& resampling) {
  Json quantities = Json::object();
  for (const Limit& limit : runs.plan.limits) {
    const Column* column = find_quantity(runs, limit.quantity);
    if (column == nullptr) continue;
    const Summary summary =
        summarise(runs, ok_values(runs, column->values), resampling, kConfidence);
    Json& entry = quantities[limit.quantity];
    entry = {{"unit", column->unit},
             {"mean", json_number(summary.mean.value)},
             {"mean_lower", json_number(summary.mean.lower)},
             {"mean_upper", json_number(summary.mean.upper)}};
    for (std::size_t q = 0; q < summary.quantiles.size(); ++q)
      entry[fmt::format("quantile_{:g}", kQuantileLevels[q])] =
          json_number(summary.quantiles[q].value);
    entry["minimum"] = limit.minimum ? Json(*limit.minimum) : Json();
    entry["maximum"] = limit.maximum ? Json(*limit.maximum) : Json();
  }
  return quantities;
}

Json row_json(const std::string& directory, const StudyData& study) {
  const StudyData runs = select_samples(study, first_runs(study));
  const Resampling resampling(runs, kUsualResamples);
  const std::vector<double> equal(runs.size(), 1.0);
  const Yield yield = estimate_yield(runs, judge_all(runs), equal, resampling, kConfidence);
  const auto jammed = std::count(runs.status.begin(), runs.status.end(), RunStatus::jammed),
             ok = std::count(runs.status.begin(), runs.status.end(), RunStatus::ok);
  return {{"directory", directory},
          {"study", study.provenance.study_name},
          {"build", study.provenance.tool_version + " " + study.provenance.tool_commit},
          {"runs", runs.size()},
          {"jammed", jammed},
          {"without_result", static_cast<long>(runs.size()) - jammed - ok},
          {"yield", json_number(yield.if_unknown_fail)},
          {"yield_lower", json_number(yield.lower_bound)},
          {"yield_upper", json_number(yield.upper_bound)},
          {"changed", nullptr},
          {"not_comparable", ""},
          {"quantities", quantities_json(runs, resampling)},
          {"changes", Json::array()},
          {"notes", Json::array()}};
}

/// What has changed since the study before, into the later one's row.
void add_changes(const StudyData& before, const StudyData& after, double error_rate, Json& row) {
  try {
    const Comparison comparison = compare_studies(before, after, error_rate, true);
    for (const StatisticChange& change : comparison.statistics)
      if (change.changed) row["changes"].push_back(to_json(change));
    row["changed"] = row["changes"].size();
    row["notes"] = comparison.notes;
  } catch (const Refused& refusal) {
    row["not_comparable"] = refusal.what();
  }
}

std::string row_text(const Json& row) {
  const auto percent = [&](const char* name) {
    return row[name].is_null() ? std::string("-")
                               : fmt::format("{:.2f}", 100 * row[name].get<double>());
  };
  std::string text =
      fmt::format("{}: {} runs, yield {} % ({} to {}), {} jammed, {} without result; {}\n",
                  row["directory"].get<std::string>(), row["runs"].get<long>(), percent("yield"),
                  percent("yield_lower"), percent("yield_upper"), row["jammed"].get<long>(),
                  row["without_result"].get<long>(), row["build"].get<std::string>());
  const Json& changes = row["changes"];
  for (std::size_t k = 0; k < std::min(changes.size(), kChangesShown); ++k)
    text += fmt::format("    changed: {} of {}: {:.6g} to {:.6g}\n",
                        changes[k]["statistic"].get<std::string>(),
                        changes[k]["quantity"].get<std::string>(), changes[k]["old"].get<double>(),
                        changes[k]["new"].get<double>());
  if (changes.size() > kChangesShown)
    text += fmt::format("    and {} more statistics\n", changes.size() - kChangesShown);
  for (const Json& note : row["notes"]) text += "    note: " + note.get<std::string>() + "\n";
  if (const std::string reason = row["not_comparable"]; !reason.empty())
    text += "    not comparable with the study before: " + reason + "\n";
  return text;
}

int run_history(const HistoryArguments& options) {
  const double steps = static_cast<double>(options.directories.size()) - 1;
  Json history = {{"kind", "history"},
                  {"report_version", kReportVersion},
                  {"confidence", kConfidence},
                  {"error_rate", options.error_rate}};
  std::optional<StudyData> before;
  for (const std::string& directory : options.directories) {
    StudyData study = results_of(read_study_data(study_file_in(directory)));
    Json& row = history["rows"].emplace_back(row_json(directory, study));
    if (before) add_changes(*before, study, options.error_rate / steps, row);
    before = std::move(study);
    print(row_text(row));
  }
  std::filesystem::create_directories(options.output);
  write_result(history, history["rows"], options.output);
  return kDone;
}

}  // namespace

Chosen history_command(CLI::App& command) {
  command.footer(
      "Directories in the order of their nights. Each is compared with the one before, as\n"
      "`cagetol compare --despite-keys` does, so that keys that differ are noted beside what they\n"
      "changed. The chance of any false alarm in the whole history is at most --error-rate.\n\n"
      "Example:\n  cagetol history out/monday out/tuesday out/wednesday -o out/history");
  auto options = std::make_shared<HistoryArguments>();
  command
      .add_option("DIR", options->directories,
                  "Directories of sweeps or recommendations, earliest first")
      ->required()
      ->expected(2, 100000)
      ->each([](const std::string& directory) { check_result_directory("DIR", directory); });
  add_output_directory(command, options->output,
                       "Directory of history.html, history.json, history.csv and figures/");
  command
      .add_option("--error-rate", options->error_rate,
                  "Probability of any false alarm when nothing has changed")
      ->check(CLI::Range(1e-9, 0.5))
      ->capture_default_str();
  return [options] { return run_history(*options); };
}

}  // namespace cagetol
