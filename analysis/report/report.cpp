#include "analysis/report/report.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "analysis/report/csv_tables.hpp"
#include "analysis/report/figure_set.hpp"
#include "analysis/report/html_report.hpp"
#include "analysis/report/write_text.hpp"

namespace cagetol {

int run_report(const std::filesystem::path& study_dir, const ReportOptions& options) {
  const StudyData study = read_study_data(study_dir / "study.h5");
  const Json report = make_report(study);
  const std::string text = report.dump(1) + "\n";
  write_text(study_dir / "report.json", text);
  write_csv_tables(study_dir, study, report);
  const FigureSet figures = draw_figures(options.python, options.figures_dir,
                                         study_dir / "report.json", study_dir / "figures");
  write_text(study_dir / "report.html", html_report(report, figures));
  if (options.json_to_stdout) {
    fmt::print("{}", text);
  } else {
    fmt::print("{}\n", report["verdict"]["statement"].get<std::string>());
    fmt::print("report: {}\n", (study_dir / "report.html").string());
  }
  if (!figures.problem.empty())
    fmt::print(stderr, "figures are missing or incomplete: {}\n", figures.problem);
  return 0;
}

}  // namespace cagetol
