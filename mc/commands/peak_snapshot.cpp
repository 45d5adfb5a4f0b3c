#include "mc/commands/peak_snapshot.hpp"

#include <optional>

#include "mc/commands/command.hpp"
#include "mc/commands/output_path.hpp"
#include "mc/run/cage_cache.hpp"
#include "mc/run/run_history.hpp"
#include "mc/run/sample_run.hpp"
#include "src/cage/table/cage_snapshot.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/input/input_error.hpp"
#include "src/operation/operating_clearance.hpp"

namespace cagetol {

CageStates state_of(const CagePeak& peak, const CageGeometry& cage) {
  const auto column = [](const std::vector<double>& values) {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<long>(values.size()));
  };
  return {column(peak.modes), column(peak.bar_force), Eigen::VectorXd::Constant(1, peak.spin),
          cage.bar_modes};
}

namespace {

void write_peak_snapshot(const std::string& file, const Scene& scene, const CageTable* table,
                         const Outcome& outcome) {
  const CagePeak& peak = outcome.cage_peak;
  if (table == nullptr || peak.bar_force.empty())
    throw InputError({}, "--snapshot", file,
                     !is_flexible(scene) ? "the cage of this scene is rigid"
                                         : "the run has no stress: " + outcome.reason,
                     !is_flexible(scene) ? "set cage.model = \"flexible\""
                                         : "choose a sample that runs to its end");
  std::optional<CageFault> fault;
  try {
    fault = write_cage_snapshot(file, *table, pocket_deviations(scene, table->cage),
                                state_of(peak, scene.cage));
  } catch (const std::runtime_error& problem) {
    throw InputError({}, "--snapshot", file, problem.what(), "choose a place that can be written");
  }
  if (fault) throw InputError({}, "--snapshot", file, fault->reason, "choose another sample");
}

}  // namespace

void add_run_file_options(CLI::App& command, RunFiles& files) {
  add_output_file(command, "-o,--output", files.history, "cagetol sealed HDF5",
                  "Write time histories to this HDF5 file");
  add_output_file(command, "--snapshot", files.snapshot, "<?xml version=\"1.0\"?>\n<VTKFile",
                  "Write the flexible cage at its largest stress to this VTU file (ParaView)");
}

Outcome run_with_files(const Study& study, const Sample& sample, const RunFiles& files) {
  if (!files.history.empty())
    require_dynamic(sample.scene, "--output", files.history, "time history");
  RunHistory history(sample.scene);
  std::function<void(const Instant&)> record;
  if (!files.history.empty()) record = [&history](const Instant& at) { history.record(at); };
  SimulateOptions options;
  if (is_flexible(study.scene)) options = CageTables(study.scene).options_of(sample.scene);
  const Outcome outcome = run_sample(study, sample, options, record);
  if (!files.history.empty()) history.write(files.history);
  if (!files.snapshot.empty())
    write_peak_snapshot(files.snapshot, sample.scene, options.cage_table.get(), outcome);
  return outcome;
}

}  // namespace cagetol
