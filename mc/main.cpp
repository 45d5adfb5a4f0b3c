// The program: parses the command line, runs the command chosen, turns what it meets into an exit
// code.
#include <malloc.h>
#include <sys/mman.h>
#include <CLI/CLI.hpp>
#include <Eigen/Core>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <sstream>

#include "analysis/format/study_file_error.hpp"
#include "mc/commands/command.hpp"
#include "mc/failure.hpp"
#include "mc/file_write.hpp"
#include "mc/log.hpp"
#include "mc/process_limits.hpp"
#include "src/input/input_error.hpp"
#include "src/input/printable.hpp"

extern char __executable_start, etext;  // the linker's: where the program's code begins and ends

namespace {

constexpr const char* kExamples =
    "Exit codes: 0 done, 1 limits not met (compare: changed) where asked to judge, 2 bad input,\n"
    "3 samples failed beyond the allowed share, 75 interrupted: start the same command again to\n"
    "go on.\n\n"
    "Examples:\n"
    "  cagetol check inputs/studies/nu205.toml\n"
    "  cagetol simulate inputs/scenes/nu205.toml --json\n"
    "  cagetol sweep inputs/studies/nu205.toml -o out/nu205\n"
    "  cagetol recommend inputs/studies/nu205.toml -o out/nu205-drawing\n"
    "  cagetol replay out/nu205 --sample 17\n"
    "  cagetol cage inputs/scenes/nu205.toml\n"
    "  cagetol bench inputs/scenes/speed-z16.toml\n"
    "  cagetol chart inputs/scenes/speed-z16.toml -o out/chart\n"
    "  cagetol ladder inputs/scenes/nu205.toml -o out/ladder\n"
    "  cagetol stability -o out/stability\n"
    "  cagetol --dump-default scene";

/// Every sample of a flexible cage takes some megabytes and frees them. Giving them back to the
/// system in between would cost as much again in page faults as computing what they hold.
void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
}

constexpr std::size_t kPage = 4096;

/// Gives `advice` of madvise for whole pages within [from, from + size).
void advise(void* from, std::size_t size, int advice) {
  if (std::align(kPage, kPage, from, size)) madvise(from, size - size % kPage, advice);
}

/// Maps pages at once, with `advice` of madvise, and touches each: a virtual machine may have page
/// tables of its own behind the system's, which only a touch fills.
void map_pages(void* from, std::size_t size, int advice) {
  advise(from, size, advice);
  const volatile char* const bytes = static_cast<const char*>(from);
  for (std::size_t k = 0; k < size; k += kPage) static_cast<void>(bytes[k]);
}

/// Takes the first megabytes that a run needs at once, in large pages where they fit, and the
/// program's code: one by one, as they are touched, pages cost a fault each, which a short run
/// would notice (tests/ACCURACY.md).
void take_memory() {
  constexpr std::size_t size = 16 << 20;
  if (void* const memory = std::malloc(size)) {
    advise(memory, size, MADV_HUGEPAGE);
    map_pages(memory, size, MADV_POPULATE_WRITE);
    std::free(memory);
  }
  map_pages(&__executable_start, static_cast<std::size_t>(&etext - &__executable_start),
            MADV_POPULATE_READ);
}

/// Likewise of the stack.
[[gnu::noinline]] void take_stack() {
  volatile char room[128 << 10];
  for (std::size_t k = 0; k < sizeof room; k += 1024) room[k] = 0;
}

/// The exit code for an exception that ends a command, after its message.
int code_of(const std::exception& error) {
  using namespace cagetol;
  const bool known = dynamic_cast<const InputError*>(&error) != nullptr ||
                     dynamic_cast<const StudyFileError*>(&error) != nullptr ||
                     dynamic_cast<const WriteError*>(&error) != nullptr ||
                     is_want_of_resources(error);
  std::fprintf(stderr, "cagetol: %s%s\n", known ? "" : "unexpected: ",
               printable(failure_text(error), LineBreaks::kept).c_str());
  return known ? kBadInput : kSamplesFailed;
}

}  // namespace

int main(int argc, char** argv) try {
  using namespace cagetol;
  require_process_limits();
  keep_freed_memory();
  take_memory();
  take_stack();
  log_to_stderr();        // stdout is for results alone, whatever the command
  Eigen::initParallel();  // asks for the caches' sizes, which takes a virtual machine 60 us
  CLI::App app{
      "Monte Carlo tolerance sensitivity of cylindrical roller bearings with flexible cages",
      "cagetol"};
  app.footer(kExamples);
  app.require_subcommand(0, 1);
  Chosen chosen;
  add_check_command(app, chosen);
  add_simulate_command(app, chosen);
  add_sweep_command(app, chosen);
  add_recommend_command(app, chosen);
  add_replay_command(app, chosen);
  add_report_command(app, chosen);
  add_cage_command(app, chosen);
  add_compare_command(app, chosen);
  add_bench_command(app, chosen);
  add_chart_command(app, chosen);
  add_ladder_command(app, chosen);
  add_stability_command(app, chosen);
  add_dump_default_option(app, chosen);
  add_version_option(app, chosen);
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
  return code_of(error);
}
