#include "analysis/report/page_writer.hpp"

#include <fmt/format.h>

#include "analysis/report/python_run.hpp"
#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

/// Exit code of write_pages.py where Python lacks Jinja2.
constexpr int kNoPackage = 3;
/// Where a page could not be written: a full disk.
constexpr int kNotWritten = 5;

}  // namespace

void remove_pages(const std::filesystem::path& directory) {
  std::error_code ignored;
  for (const char* name : {"figures", "report.html", "report.pdf", "appendix.pdf"})
    std::filesystem::remove_all(directory / name, ignored);
}

std::string write_pages(const PageWriter& writer, const std::filesystem::path& report_json) {
  const auto directory = report_json.parent_path();
  const auto figures = directory / "figures",
             html = std::filesystem::path(report_json).replace_extension(".html"),
             pdf = std::filesystem::path(report_json).replace_extension(".pdf");
  std::error_code ignored;
  std::filesystem::create_directories(figures, ignored);
  std::vector<std::string> arguments = {report_json.string(), html.string()};
  if (writer.figures)
    arguments.insert(arguments.end(), {"--figures", writer.figures_dir.string(), figures.string()});
  if (writer.pdf) arguments.insert(arguments.end(), {"--pdf", pdf.string()});
  const PythonRun run = run_python(writer.python, writer.pages_dir / "write_pages.py", arguments,
                                   figures / "pages.log");
  if (run.problem.empty()) return {};
  if (run.code == kNotWritten)
    throw UnfinishedWrite(directory.string(), "its pages cannot be written: " + run.problem,
                          "free some space, then run `cagetol report DIR` again");
  if (std::filesystem::exists(html)) return "the report is incomplete: " + run.problem;
  const bool lacks_packages = run.code == kNoPackage || run.code == -1;
  return fmt::format("{} is not written: {}{}. {} and the CSV tables are complete",
                     html.filename().string(), run.problem,
                     lacks_packages
                         ? "; install Debian's python3, python3-jinja2 and, for figures, "
                           "python3-matplotlib"
                         : "",
                     report_json.filename().string());
}

}  // namespace cagetol
