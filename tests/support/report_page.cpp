#include "tests/support/report_page.hpp"

#include <fstream>
#include <sstream>

#include "analysis/report/page_writer.hpp"
#include "analysis/report/report.hpp"
#include "tests/support/process.hpp"

namespace cagetol {
namespace {

std::string laid_out(const nlohmann::ordered_json& report, bool figures) {
  const ScratchDirectory scratch;
  const std::filesystem::path file = scratch / "report.json";
  std::ofstream(file) << report;
  const ReportOptions options;
  const std::string problem =
      write_pages({options.pages_dir, options.figures_dir, options.python, figures}, file);
  const std::string page = page_text(scratch / "report.html");
  return page.empty() ? problem : page;
}

}  // namespace

std::string page_of(const nlohmann::ordered_json& report) {
  return laid_out(report, false);
}

std::string page_with_figures(const nlohmann::ordered_json& report) {
  return laid_out(report, true);
}

std::string section_of(const std::string& page, const std::string& name) {
  const std::size_t begin = page.find("<section id=\"" + name + "\"");
  if (begin == std::string::npos) return {};
  return page.substr(begin, page.find("</section>", begin) - begin);
}

std::string page_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  std::string text = content.str();
  const std::string mark = "<wbr>";
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at))
    text.erase(at, mark.size());
  return text;
}

}  // namespace cagetol
