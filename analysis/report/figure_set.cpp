#include "analysis/report/figure_set.hpp"

#include "analysis/report/python_run.hpp"

namespace cagetol {

FigureSet draw_figures(const std::string& python, const std::filesystem::path& scripts,
                       const std::filesystem::path& report_json,
                       const std::filesystem::path& output_dir) {
  FigureSet figures;
  std::error_code ignored;
  std::filesystem::remove_all(output_dir, ignored);
  std::filesystem::create_directories(output_dir, ignored);
  figures.problem = run_python(python, scripts / "draw.py",
                               {report_json.string(), output_dir.string()}, output_dir / "draw.log")
                        .problem;
  std::filesystem::directory_iterator entries(output_dir, ignored), end;
  for (; entries != end; entries.increment(ignored))
    if (entries->path().extension() == ".svg")
      figures.svg[entries->path().stem()] = file_text(entries->path());
  return figures;
}

}  // namespace cagetol
