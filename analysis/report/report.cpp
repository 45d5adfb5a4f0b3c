#include "analysis/report/report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "analysis/report/cage_peak.hpp"
#include "analysis/report/csv_tables.hpp"
#include "analysis/report/page_writer.hpp"
#include "analysis/report/refining_ladder.hpp"
#include "analysis/report/write_text.hpp"
#include "analysis/tolerance/confirmation.hpp"

namespace cagetol {

namespace {

/// The attempts to confirm whose runs are all there.
std::vector<StudyData> read_confirmations(const std::filesystem::path& directory) {
  std::vector<StudyData> confirmations;
  for (int attempt = 1;; ++attempt) {
    const auto file = directory / fmt::format("confirm-{}", attempt) / "study.h5";
    if (!std::filesystem::exists(file)) return confirmations;
    StudyData runs = read_study_data(file);
    if (!is_complete(runs)) return confirmations;
    confirmations.push_back(std::move(runs));
  }
}

}  // namespace

std::filesystem::path study_file_in(const std::filesystem::path& directory) {
  const auto mixture = directory / "mixture" / "study.h5";
  return std::filesystem::exists(mixture) ? mixture : directory / "study.h5";
}

ExitCode run_report(const std::filesystem::path& study_dir, const ReportOptions& options) {
  const auto file = study_file_in(study_dir);
  const bool staged = file.parent_path() != study_dir;
  const StudyData study = read_study_data(file);
  const auto confirmations = read_confirmations(study_dir);
  const Json report = make_report(study, confirmations, staged ? "DIR/mixture" : "DIR",
                                  read_cage_peak(file.parent_path(), study),
                                  read_refining_ladder(file.parent_path()),
                                  read_assumption_runs(study_dir, confirmations),
                                  options.bearing ? options.bearing(file) : Json());
  const std::string text = report.dump(1) + "\n";
  remove_pages(study_dir);
  write_text(study_dir / "report.json", text);
  write_csv_tables(study_dir, study, report);
  const std::string problem = write_pages(
      {options.pages_dir, options.figures_dir, options.python, options.figures, options.pdf},
      study_dir / "report.json");
  if (options.json_to_stdout) {
    fmt::print("{}", text);
  } else {
    fmt::print("{}\n", report["verdict"]["statement"].get<std::string>());
    for (const char* page : {"report.html", "report.pdf"})
      if (std::filesystem::exists(study_dir / page))
        fmt::print("report: {}\n", (study_dir / page).string());
  }
  if (!problem.empty()) std::fputs((problem + "\n").c_str(), stderr);
  return kDone;
}

}  // namespace cagetol
