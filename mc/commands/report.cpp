// cagetol report: statistics, contributors, tolerance and pictures of a finished sweep.
#include <memory>

#include "analysis/report/report.hpp"
#include "mc/commands/bearing_facts.hpp"
#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/study/document.hpp"

namespace cagetol {

Chosen report_command(CLI::App& command) {
  command.footer("Examples:\n  cagetol report out/nu205\n  cagetol report out/nu205 --pdf");
  struct Arguments {
    std::string directory, document;
    ReportOptions options;
  };
  const auto arguments = std::make_shared<Arguments>();
  arguments->options.bearing = bearing_facts;
  add_result_directory(command, "DIR", arguments->directory,
                       "Directory of a sweep or a recommendation");
  command.add_flag("--json", arguments->options.json_to_stdout,
                   "Print report.json on standard output");
  command.add_flag(
      "--pdf", arguments->options.pdf,
      "Write report.pdf to send, of four pages at most, and appendix.pdf (needs weasyprint)");
  command.add_option("--document", arguments->document,
                     "TOML file whose section [document] takes the place of the study's: customer, "
                     "project, drawing, revision, author, checked_by, date");
  return [arguments] {
    if (!arguments->document.empty())
      arguments->options.document = read_document(arguments->document);
    return run_report(arguments->directory, arguments->options);
  };
}

}  // namespace cagetol
