// The program: parses the command line, runs the command chosen, returns its exit code.
#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <cstdio>
#include <exception>
#include <sstream>

#include "mc/commands/subcommands.hpp"
#include "mc/host/failure.hpp"
#include "mc/host/log.hpp"
#include "mc/host/page_faults.hpp"
#include "mc/host/process_limits.hpp"
#include "src/input/printable.hpp"

int main(int argc, char** argv) try {
  using namespace cagetol;
  open_standard_streams();
  require_process_limits();
  avoid_page_faults();
  log_to_stderr();        // stdout is for results alone, whatever the command
  Eigen::initParallel();  // asks for the caches' sizes, which takes a virtual machine 60 us
  CLI::App app{
      "Monte Carlo tolerance sensitivity of cylindrical roller bearings with flexible cages",
      "cagetol"};
  Chosen chosen;
  add_subcommands(app, chosen);
  add_dump_default_option(app, chosen);
  add_version_option(app, chosen);
  app.set_help_all_flag("--help-all", "Print the help of every command");
  try {
    app.parse(argc, argv);
    if (chosen) return chosen();
    std::fputs(app.help().c_str(), stderr);
    return kBadInput;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error), kDone;
    std::ostringstream said;
    app.exit(error, said, said);
    std::fputs(printable(said.str(), LineBreaks::kept).c_str(), stderr);
    return kBadInput;
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "cagetol: %s\n",
               cagetol::printable(cagetol::ending_text(error), cagetol::LineBreaks::kept).c_str());
  return cagetol::exit_code_for(error);
}
