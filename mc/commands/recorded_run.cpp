#include "mc/commands/recorded_run.hpp"

#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/run/cage_cache.hpp"
#include "mc/run/run_history.hpp"
#include "mc/run/sample_run.hpp"

namespace cagetol {

void add_history_option(CLI::App& command, std::string& history) {
  add_output_file(command, "-o,--output", history, "cagetol sealed HDF5",
                  "Write time histories to this HDF5 file");
}

Outcome recorded_run(const Study& study, const Sample& sample, const std::string& history) {
  SimulateOptions options;
  if (is_flexible(study.scene)) options = CageTables(study.scene).options_of(sample.scene);
  if (history.empty()) return run_sample(study, sample, options);
  require_dynamic(sample.scene, "--output", history, "time history");
  RunHistory histories(sample.scene);
  const Outcome outcome =
      run_sample(study, sample, options, [&](const Instant& at) { histories.record(at); });
  histories.write(history);
  return outcome;
}

}  // namespace cagetol
