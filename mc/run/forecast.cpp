#include "mc/run/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "mc/host/machine.hpp"
#include "mc/run/stored_outcome.hpp"
#include "mc/study/operating_points.hpp"
#include "mc/study/sample.hpp"
#include "src/input/input_error.hpp"
#include "src/quantities/quantity_labels.hpp"

namespace cagetol {
namespace {

constexpr double kProgram = 48e6;           // measured: 46 MB of a rank under Open MPI 4
constexpr double kRecordFrame = 12;         // of a journal's record
constexpr double kEmptyStudyFile = 150e3;   // names, units and descriptions of the datasets
constexpr double kReason = 32;              // of a sample that has none, in study.h5
constexpr double kCageBytesPerNode = 24e3;  // measured: 17 kB at 6,000 nodes, 26 kB at 36,000

/// Numbers of one sample that are drawn again for study.h5: row, replicate, lot, candidate, and of
/// each input its parts and its value.
double drawn_numbers(const Study& study) {
  double numbers = 4;
  for (const UncertainInput& input : study.inputs) {
    const auto width = static_cast<double>(input.per_pocket ? study.scene.bearing.roller_count : 1);
    numbers += width + (input.lot ? 1 : 0) + (input.pocket ? width : 0) + (input.noise ? 1 : 0);
  }
  return numbers;
}

std::string size_text(double bytes) {
  const char* units[] = {"kB", "MB", "GB", "TB", "PB"};
  double amount = bytes / 1e3;
  std::size_t unit = 0;
  for (; amount >= 999.5 && unit + 1 < std::size(units); ++unit) amount /= 1e3;
  return fmt::format("{:.{}f} {}", amount, amount < 9.95 ? 1 : 0, units[unit]);
}

std::string counts_text(const SweepForecast& forecast) {
  return fmt::format("{} rows, {} samples with {} numbers each", forecast.rows, forecast.samples,
                     forecast.numbers);
}

double stored_bytes(const std::string& directory) {
  namespace fs = std::filesystem;
  std::error_code error;
  double bytes = 0;
  const auto add = [&](const fs::path& file) {
    const auto size = fs::file_size(file, error);
    if (!error) bytes += static_cast<double>(size);
  };
  add(fs::path(directory) / "study.h5");
  for (fs::directory_iterator entry(fs::path(directory) / "journal", error), end;
       !error && entry != end; entry.increment(error))
    add(entry->path());
  return bytes;
}

[[noreturn]] void refuse(const SweepForecast& forecast, const std::string& what, double needed,
                         const Room& room, const std::string& remedy) {
  throw InputError({}, "samples", std::to_string(forecast.samples),
                   fmt::format("{} need about {} of {}; there are {} ({})", counts_text(forecast),
                               size_text(needed), what, size_text(room.bytes), room.name),
                   remedy);
}

}  // namespace

SweepForecast forecast_sweep(const Study& study) {
  const auto quantities = static_cast<double>(quantity_count(quantity_labels(study)));
  const auto fields = static_cast<double>(stored_run_fields().size());
  const double results = quantities + fields, drawn = drawn_numbers(study);

  SweepForecast forecast;
  forecast.rows = static_cast<std::uint64_t>(study.samples);
  forecast.samples = sample_count(study);
  forecast.numbers = static_cast<std::uint64_t>(results + drawn);
  const auto samples = static_cast<double>(forecast.samples);

  // Started (kind, id) and finished (kind, id, outcome_bytes: id, status, reason, pocket,
  // interference, three arrays with their lengths, wall clock, rank).
  const double record = 2 * (kRecordFrame + 9) + 8 + 4 + 8 + 4 + 8 + 3 * 8 + 8 + 4 + 8 * results;
  // A node of the map, and blocks of the heap for the arrays.
  const double outcome = 48 + sizeof(StoredOutcome) + 3 * 16 + 8 * results;
  // id, status, pocket, interference, wall clock and rank beside what is drawn and results.
  const double in_file = 8 * (6 + drawn + results) + kReason;
  const double texts = static_cast<double>(study.resolved_toml.size() + study.resolved_json.size());
  forecast.journal_bytes = samples * record;
  forecast.study_file_bytes = kEmptyStudyFile + samples * in_file + texts;
  const double reading = 2 * samples * record + 2 * samples * outcome;
  const double building = samples * outcome + 12 * samples * drawn + 2 * forecast.study_file_bytes;
  forecast.rank_memory = kProgram;
  forecast.rank_0_memory =
      kProgram + 16 * samples + samples * outcome + std::max(reading, building);
  return forecast;
}

double forecast_cage_table(const Scene& scene) {
  if (!is_flexible(scene)) return 0;
  const CageDimensions cage = cage_dimensions(scene);
  const MeshCounts n = mesh_counts(cage, scene.cage.mesh_density);
  const auto count = [](long value) { return static_cast<double>(value); };
  const double layer = (2 * count(n.half_bar) + 1) * (2 * count(n.side) + count(n.length) + 1) +
                       (count(n.pocket) - 1) * 2 * (count(n.side) + 1);
  return kCageBytesPerNode * count(cage.pocket_count) * (count(n.radial) + 1) * layer;
}

std::string forecast_text(const SweepForecast& forecast) {
  return fmt::format(
      "{}: rank 0 needs up to {} of memory, every other rank {}; the disk {} of journals and {} of "
      "study.h5",
      counts_text(forecast), size_text(forecast.rank_0_memory), size_text(forecast.rank_memory),
      size_text(forecast.journal_bytes), size_text(forecast.study_file_bytes));
}

void require_memory(const SweepForecast& forecast, int ranks_here) {
  const char* remedy =
      "ask for fewer samples or extra_replicates, or use a machine or a limit with "
      "more memory";
  const Room own = room_of_process(), machine = room_of_machine();
  // The program itself is there already.
  const double added = forecast.rank_0_memory - kProgram;
  if (added > kMinimumRefused && added > own.bytes)
    refuse(forecast, "memory in rank 0", added, own, remedy);
  const double together = added + (ranks_here - 1) * forecast.rank_memory;
  if (together > kMinimumRefused && together > machine.bytes)
    refuse(forecast, "memory", together, machine, remedy);
}

void require_disk(const SweepForecast& forecast, const std::string& directory) {
  const Room room = room_on_disk(directory);
  const double needed = forecast.disk_bytes() - stored_bytes(directory);
  if (needed > kMinimumRefused && needed > room.bytes)
    refuse(forecast, "disk", needed, room,
           "free some space, choose another output directory with -o, or ask for fewer samples "
           "or extra_replicates");
}

void require_cage_memory(const Scene& scene) {
  const double needed = forecast_cage_table(scene);
  const Room own = room_of_process(), machine = room_of_machine();
  const Room& room = own.bytes < machine.bytes ? own : machine;
  if (!(needed > kMinimumRefused && needed > room.bytes)) return;
  throw InputError({}, "cage.mesh_density", std::to_string(scene.cage.mesh_density),
                   fmt::format("making the table of this cage takes about {} of memory; there are "
                               "{} ({})",
                               size_text(needed), size_text(room.bytes), room.name),
                   "use a coarser mesh, or check the cage's diameters: elements are as thin as the "
                   "cage");
}

int ranks_on_this_machine() {
  for (const char* name :
       {"OMPI_COMM_WORLD_LOCAL_SIZE", "MPI_LOCALNRANKS", "SLURM_NTASKS_PER_NODE"})
    if (const char* value = std::getenv(name)) return std::max(1, std::atoi(value));
  return 1;
}

}  // namespace cagetol
