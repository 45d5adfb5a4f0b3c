// The report of a study: report.json with every number, CSV tables, figures and one self-contained
// report.html.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/report/assumption_runs.hpp"
#include "analysis/study/study_data.hpp"
#include "mc/study_file/exit_code.hpp"
#include "mc/study_file/shipped_file.hpp"

namespace cagetol {

/// Of report.json, rig.json and map.json: what the pages lay out (analysis/pages/write_pages.py).
inline constexpr int kReportVersion = 3;

struct ReportOptions {
  /// Python scripts that draw from report.json, and those that lay it out.
  std::filesystem::path figures_dir = shipped_file("analysis/figures"),
                        pages_dir = shipped_file("analysis/pages");
  /// Debian's own interpreter: it has Jinja2 and matplotlib, whatever other python3 comes first on
  /// the PATH.
  std::string python = "/usr/bin/python3";
  bool json_to_stdout = false;  ///< print report.json instead of the verdict
  /// What the bearing of a study file is, for the page of its operating point: this room knows
  /// nothing of bearings. Null where it cannot say; empty: nothing is said.
  std::function<nlohmann::ordered_json(const std::filesystem::path& study_file)> bearing = {};
  bool figures = true;  ///< draw them: seconds of Python
  bool pdf = false;     ///< report.pdf and appendix.pdf, too
  /// Title block in place of the study's, with the keys of its section [document].
  std::optional<nlohmann::ordered_json> document = {};
  std::filesystem::path into = {};  ///< folder of what is written, whole; empty: the study's own
  /// States other limits, target or confidence for runs that have been read. The report is then of
  /// limited quantities alone, and has the yield over the value of each limit.
  std::function<void(StudyPlan&)> restate = {};
};

/// Every number of the report, from the study alone: the same study gives the same bytes.
/// `confirmations` are the attempts to confirm its recommendation, `directory` is how replay
/// commands name the place of its runs, `cage_peak` what read_cage_peak (cage_peak.hpp) found,
/// `refining_ladder` what read_refining_ladder (refining_ladder.hpp) did, `assumptions` what
/// read_assumption_runs (assumption_runs.hpp) did, `bearing` what ReportOptions::bearing said.
nlohmann::ordered_json make_report(const StudyData& study,
                                   const std::vector<StudyData>& confirmations = {},
                                   const std::string& directory = "DIR",
                                   const nlohmann::ordered_json& cage_peak = {},
                                   const nlohmann::ordered_json& refining_ladder = {},
                                   const std::optional<AssumptionRuns>& assumptions = {},
                                   const nlohmann::ordered_json& bearing = {});

/// DIR/mixture/study.h5 where DIR holds the stages of a recommendation, or its pilot's; otherwise
/// DIR/study.h5.
std::filesystem::path study_file_in(const std::filesystem::path& directory);

/// Reads DIR/study.h5, or DIR/mixture/study.h5 and the confirmations beside it, and writes
/// report.json, report.html, figures/ and the tables of csv_tables.hpp beside it. Pages and figures
/// that cannot be made are left out; what is missing for them is printed. Prints the verdict. The
/// map in DIR/map becomes part of it; where DIR holds no runs beside, its own pages are written.
/// Returns kDone; throws StudyFileError.
ExitCode run_report(const std::filesystem::path& study_dir, const ReportOptions& options = {});

}  // namespace cagetol
