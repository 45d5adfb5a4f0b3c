#include "mc/run/cage_cache.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "mc/host/build_info.hpp"
#include "mc/host/log.hpp"
#include "mc/host/progress.hpp"
#include "mc/host/sealed_bytes.hpp"
#include "mc/ranks/signals.hpp"
#include "mc/run/forecast.hpp"
#include "src/cage/solve/unsolved_cage.hpp"
#include "src/cage/table/cage_table_bytes.hpp"
#include "src/input/input_error.hpp"
#include "src/operation/operating_clearance.hpp"

namespace cagetol {
namespace {

/// Tables of one scene; reading one again takes some milliseconds.
constexpr std::size_t kMostInMemory = 16;

constexpr int kFormat = 14;
constexpr const char* kOtherFolder =
    "set CAGETOL_CACHE to a folder that has room and that you may write to";
/// What files of formats up to 10, which had no checksum, begin with.
constexpr const char* kEarlierFormats = "cagetol cage table ";

/// An environment variable, empty where it is not set.
std::filesystem::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// A bar that rewrites itself on a terminal; in a log only its beginning.
void show_progress(const std::string& what, double share) {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  if (!terminal && share > 0) return;
  if (terminal)
    say("\rmaking {}, once for this cage: {}{}", what, progress_bar(share), share >= 1 ? "\n" : "");
  else
    say("making {}, once for this cage\n", what);
  std::fflush(stderr);
}

}  // namespace

std::filesystem::path cage_cache_folder() {
  if (const auto chosen = variable("CAGETOL_CACHE"); !chosen.empty()) return chosen;
  if (const auto cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache / "cagetol";
  if (const auto home = variable("HOME"); !home.empty()) return home / ".cache" / "cagetol";
  std::error_code error;
  const auto scratch = std::filesystem::temp_directory_path(error);
  return (error ? "/tmp" : scratch) / fmt::format("cagetol-{}", ::getuid());
}

std::shared_ptr<const CageTable> made_cage_table(const Scene& nominal,
                                                 const TableProgress& progress) {
  try {
    return make_scene_cage_table(nominal, {}, progress);
  } catch (const UnsolvedCage& problem) {
    throw InputError(
        {}, "cage.mesh_density", std::to_string(nominal.cage.mesh_density),
        std::string("the finite elements of the flexible cage cannot be solved: ") + problem.what(),
        "choose another density, or give the cage less slender bars and rings, or set "
        "cage.model = \"rigid\"");
  }
}

CageTables::CageTables(const Scene& nominal) : nominal_(nominal) {
  const CageDimensions cage = cage_dimensions(nominal);
  const std::vector<PocketDeviation> none(static_cast<std::size_t>(cage.pocket_count));
  if (const auto fault = cage_fault(cage, none))
    throw InputError({}, "cage", "", "the cage without deviations is impossible: " + fault->reason,
                     "check the dimensions of [cage] and the number of rollers");
}

std::shared_ptr<const CageTable> CageTables::of(const Scene& sample) {
  return table(point_of(sample), "a cage table");
}

void CageTables::make(const std::set<GridPoint>& points, int rank, int ranks) {
  speaks_of_folder_ = speaks_of_folder_ && rank == 0;
  int number = 0;
  for (const GridPoint& point : points) {
    if (number++ % ranks != rank || SignalWatch::draining()) continue;
    try {
      table(point, fmt::format("cage table {} of {}", number, points.size()));
    } catch (const UnsolvedCage&) {
      continue;
    }
  }
}

SimulateOptions CageTables::options_of(const Scene& sample) {
  SimulateOptions options;
  try {
    options.cage_table = of(sample);
  } catch (const UnsolvedCage& problem) {
    options.why_no_cage = problem.what();
  }
  return options;
}

std::shared_ptr<const CageTable> CageTables::table(const GridPoint& point,
                                                   const std::string& what) {
  const auto found =
      std::find_if(tables_.begin(), tables_.end(), [&](const auto& t) { return t.first == point; });
  if (found != tables_.end()) {
    std::rotate(tables_.begin(), found, found + 1);
  } else {
    if (tables_.size() == kMostInMemory) tables_.pop_back();
    auto kept = read(point);
    if (!kept) {
      require_cage_memory(nominal_);
      kept = make(point, what);
      keep(point, *kept);
    }
    tables_.emplace_front(point, std::move(kept));
  }
  return tables_.front().second;
}

std::shared_ptr<const CageTable> CageTables::make(const GridPoint& point, const std::string& what) {
  const TableProgress progress = [&](double share) { show_progress(what, share); };
  if (point == GridPoint{}) return made_cage_table(nominal_, progress);
  if (const auto known = unsolved_.find(point); known != unsolved_.end())
    throw UnsolvedCage(known->second);
  try {
    return make_scene_cage_table(nominal_, point, progress);
  } catch (const UnsolvedCage& problem) {
    unsolved_[point] = problem.what();
    throw;
  }
}

std::string CageTables::file_name(const GridPoint& point) const {
  return "cage-" + scene_cage_table_key(nominal_, point) + ".bin";
}

std::string CageTables::head(const GridPoint& point) const {
  return fmt::format("cage table {}\n{}\n{}\n", kFormat, scene_cage_table_key(nominal_, point),
                     build_id(build_info()));
}

void CageTables::open_folder() {
  if (folder_was_opened_) return;
  folder_was_opened_ = true;
  try {
    folder_.emplace(cage_cache_folder());
  } catch (const NotPrivate& problem) {
    warn_of_folder(problem.what(), fmt::format("`chmod go-w {}` where it is yours, or set "
                                               "CAGETOL_CACHE to a folder of your own",
                                               cage_cache_folder().string()));
  } catch (const WriteError& problem) {
    warn_of_folder(problem.problem(), kOtherFolder);
  }
}

void CageTables::warn_of_folder(const std::string& problem, const std::string& remedy) {
  if (speaks_of_folder_)
    spdlog::warn("{}: cage tables are not kept, each run makes them again\n  remedy: {}", problem,
                 remedy);
  speaks_of_folder_ = false;
}

std::shared_ptr<const CageTable> CageTables::read(const GridPoint& point) {
  open_folder();
  if (!folder_) return nullptr;
  const std::string name = file_name(point);
  const auto again = [](const std::string& problem) {
    spdlog::warn("{}: this cage table is not used but made again", problem);
    return nullptr;
  };
  try {
    const auto bytes = folder_->read(name);
    if (!bytes || bytes->starts_with(kEarlierFormats)) return nullptr;
    const Unsealed found = unsealed_bytes(*bytes, head(point));
    if (found.state == SealedState::other_head) return nullptr;  // of another build
    if (found.state == SealedState::whole)
      if (auto table = scene_cage_table_from_bytes(nominal_, point, found.content)) return table;
    return again((folder_->path() / name).string() + " is damaged (its checksum does not match)");
  } catch (const NotPrivate& problem) {
    return again(problem.what());
  }
}

void CageTables::keep(const GridPoint& point, const CageTable& table) {
  if (!folder_) return;
  try {
    folder_->replace(file_name(point), sealed_bytes(head(point), cage_table_bytes(table)));
  } catch (const WriteError& problem) {
    warn_of_folder(problem.problem(), kOtherFolder);
  }
}

}  // namespace cagetol
