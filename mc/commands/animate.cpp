// cagetol animate DIR --sample ID: the motion of one sample of a sweep as a page to look at.
#include <fmt/format.h>

#include <memory>

#include "mc/commands/command.hpp"
#include "mc/commands/motion_page.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/host/log.hpp"
#include "mc/sweep/sample_motion.hpp"

namespace cagetol {
namespace {

struct AnimateArguments {
  std::string directory, file;
  std::uint64_t sample = 0;
};

int run_animate(const AnimateArguments& options) {
  const StoredSample stored = read_stored_sample(options.directory, options.sample);
  for (const std::string& note : stored.notes) say("cagetol: {}\n", note);
  require_dynamic(stored.sample.scene, "animate", options.directory, "motion");
  const auto [outcome, frames] = record_motion(stored);
  const std::string file = options.file.empty()
                               ? fmt::format("{}/motion-{}.html", options.directory, options.sample)
                               : options.file;
  write_motion_page(
      file,
      fmt::format("{}, sample {}: {}{}", stored.study.name, options.sample,
                  status_name(outcome.status), outcome.reason.empty() ? "" : ", " + outcome.reason),
      frames);
  fmt::print("{}\n", file);
  return kDone;
}

}  // namespace

Chosen animate_command(CLI::App& command) {
  command.footer(
      "The page shows the last two revolutions of the cage: rollers in their pockets, the orbit\n"
      "of the cage, bar forces and stress. It needs a browser alone.\n\n"
      "Examples:\n  cagetol animate out/nu205 --sample 17\n"
      "  cagetol animate out/nu205 --sample 17 -o sample17.html");
  auto options = std::make_shared<AnimateArguments>();
  add_result_directory(command, "DIR", options->directory, "Directory of a sweep");
  command.add_option("--sample", options->sample, "Id of the sample")
      ->required()
      ->check(CLI::Range(0L, kMostSamples));
  add_output_file(command, "-o,--output", options->file, "<!DOCTYPE html>",
                  "Write the page to this file (DIR/motion-ID.html)");
  return [options] { return run_animate(*options); };
}

}  // namespace cagetol
