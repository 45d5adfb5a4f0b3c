#include "analysis/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

#include "analysis/report/cage_peak.hpp"
#include "analysis/report/csv_tables.hpp"
#include "analysis/report/json_parts.hpp"
#include "analysis/report/page_writer.hpp"
#include "analysis/report/python_run.hpp"
#include "analysis/report/refining_ladder.hpp"
#include "analysis/report/write_text.hpp"
#include "analysis/tolerance/centre_response.hpp"
#include "analysis/tolerance/confirmation.hpp"

namespace cagetol {

namespace {

StudyData read_runs(const std::filesystem::path& file, const ReportOptions& options) {
  StudyData runs = read_study_data(file);
  const Json before = judgement_of(runs.plan);
  if (options.restate) {
    options.restate(runs.plan);
    std::erase_if(runs.quantities, [&](const Column& column) {
      return column.name != kCentreQuantity &&
             std::none_of(runs.plan.limits.begin(), runs.plan.limits.end(),
                          [&](const Limit& limit) { return limit.quantity == column.name; });
    });
  }
  runs.judged_again = judgement_of(runs.plan) != before;
  return runs;
}

/// The attempts to confirm whose runs are all there.
std::vector<StudyData> read_confirmations(const std::filesystem::path& directory,
                                          const ReportOptions& options) {
  std::vector<StudyData> confirmations;
  for (int attempt = 1;; ++attempt) {
    const auto file = directory / fmt::format("confirm-{}", attempt) / "study.h5";
    if (!std::filesystem::exists(file)) return confirmations;
    StudyData runs = read_runs(file, options);
    runs.judged_again = is_judged_again(file.parent_path(), runs.plan);
    if (!is_complete(runs)) return confirmations;
    confirmations.push_back(std::move(runs));
  }
}

/// That `cagetol map` has left in the directory; null where there is none.
Json read_map(const std::filesystem::path& file) {
  const Json map = Json::parse(file_text(file), nullptr, false);
  return map.is_object() && map.value("report_version", 0) == kReportVersion ? map : Json();
}

/// What `cagetol rare` found by the limits of these runs; null where it did not.
Json read_rare(const std::filesystem::path& directory, const StudyPlan& plan) {
  std::ifstream file(directory / "rare" / "rare.json");
  const Json rare = file ? Json::parse(file, nullptr, false) : Json();
  return rare.is_object() && rare.value("judgement", Json()) == judgement_of(plan) ? rare : Json();
}

/// `made` takes the place of `folder`, and what was there goes.
void replace_folder(const std::filesystem::path& made, const std::filesystem::path& folder) {
  const auto before = folder.string() + ".before";
  std::filesystem::remove_all(before);
  if (std::filesystem::exists(folder)) std::filesystem::rename(folder, before);
  std::filesystem::rename(made, folder);
  std::filesystem::remove_all(before);
}

}  // namespace

std::filesystem::path study_file_in(const std::filesystem::path& directory) {
  for (const char* stage : {"mixture", "pilot"})
    if (const auto file = directory / stage / "study.h5"; std::filesystem::exists(file))
      return file;
  return directory / "study.h5";
}

ExitCode run_report(const std::filesystem::path& study_dir, const ReportOptions& options) {
  const auto file = study_file_in(study_dir), map_file = study_dir / "map" / "map.json";
  const Json map = read_map(map_file);
  const PageWriter writer{options.pages_dir, options.figures_dir, options.python, options.figures,
                          options.pdf};
  if (!map.is_null() && !std::filesystem::exists(file)) {
    const std::string problem = write_pages(writer, map_file);
    fmt::print("{}",
               options.json_to_stdout
                   ? file_text(map_file)
                   : fmt::format("map: {}/map.html\n{}", map_file.parent_path().string(), problem));
    return kDone;
  }
  const bool apart = !options.into.empty();
  const std::filesystem::path place = apart ? options.into : study_dir,
                              into = apart ? place.string() + ".made" : study_dir.string();
  const StudyData study = read_runs(file, options);
  const auto confirmations = read_confirmations(study_dir, options);
  auto assumptions = read_assumption_runs(study_dir, confirmations);
  if (assumptions && options.restate)
    for (StudyData& runs : assumptions->runs) options.restate(runs.plan);
  Json report = make_report(
      study, confirmations,
      file.parent_path() == study_dir ? "DIR" : "DIR/" + file.parent_path().filename().string(),
      read_cage_peak(file.parent_path(), study), read_refining_ladder(file.parent_path()),
      assumptions, options.bearing ? options.bearing(file) : Json());
  if (options.document) {
    const Json number = report["document"]["number"];
    (report["document"] = *options.document)["number"] = number;
  }
  if (!map.is_null() && !options.restate) report["map"] = map;
  if (Json rare = read_rare(study_dir, study.plan); !rare.is_null())
    report["rare"] = std::move(rare);
  if (options.restate) report["limit_curves"] = limit_curves_json(study);
  const std::string text = report.dump(1) + "\n";
  if (apart) {
    std::filesystem::remove_all(into);
    std::filesystem::create_directories(into);
  }
  remove_pages(into);
  write_text(into / "report.json", text);
  write_csv_tables(into, study, report);
  const std::string problem = write_pages(writer, into / "report.json");
  if (apart) replace_folder(into, place);
  if (options.json_to_stdout) {
    fmt::print("{}", text);
  } else {
    fmt::print("{}\n", report["verdict"]["statement"].get<std::string>());
    if (apart)
      for (const Json& next : report["verdict"]["next"])
        fmt::print("next: {}\n  {}\n", next["missing"].get<std::string>(),
                   next["command"].is_string() ? next["command"].get<std::string>() : "");
    for (const char* page : {"report.html", "report.pdf", "appendix.pdf"})
      if (std::filesystem::exists(place / page))
        fmt::print("report: {}\n", (place / page).string());
  }
  if (!problem.empty()) std::fputs((problem + "\n").c_str(), stderr);
  return kDone;
}

}  // namespace cagetol
