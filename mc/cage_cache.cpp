#include "mc/cage_cache.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "mc/forecast.hpp"
#include "mc/signals.hpp"
#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

/// Tables of one scene; reading one again takes some milliseconds.
constexpr std::size_t kMostInMemory = 16;

/// An environment variable, empty where it is not set.
std::filesystem::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// One line that rewrites itself on a terminal; in a log only its beginning.
void show_progress(const std::string& what, double share) {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  if (!terminal && share > 0) return;
  fmt::print(stderr, "{}making {}, once for this cage: {:3.0f} %{}", terminal ? "\r" : "", what,
             100 * share, !terminal || share >= 1 ? "\n" : "");
  std::fflush(stderr);
}

}  // namespace

std::filesystem::path cage_cache_folder() {
  if (const auto chosen = variable("CAGETOL_CACHE"); !chosen.empty()) return chosen;
  if (const auto cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache / "cagetol";
  if (const auto home = variable("HOME"); !home.empty()) return home / ".cache" / "cagetol";
  return std::filesystem::temp_directory_path() / fmt::format("cagetol-{}", ::getuid());
}

CageTables::CageTables(const Scene& nominal) : nominal_(nominal) {
  const CageDimensions cage = cage_dimensions(nominal.cage, nominal.bearing.roller_count);
  const std::vector<PocketDeviation> none(static_cast<std::size_t>(cage.pocket_count));
  if (const auto fault = cage_fault(cage, none))
    throw InputError({}, "cage", "", "the cage without deviations is impossible: " + fault->reason,
                     "check the dimensions of [cage] and the number of rollers");
}

std::shared_ptr<const CageTable> CageTables::of(const Scene& sample) {
  return table(point_of(sample), "a cage table");
}

void CageTables::make(const std::set<GridPoint>& points, int rank, int ranks) {
  int number = 0;
  for (const GridPoint& point : points) {
    if (number++ % ranks != rank || SignalWatch::draining()) continue;
    table(point, fmt::format("cage table {} of {}", number, points.size()));
  }
}

std::shared_ptr<const CageTable> CageTables::table(const GridPoint& point,
                                                   const std::string& what) {
  const auto found =
      std::find_if(tables_.begin(), tables_.end(), [&](const auto& t) { return t.first == point; });
  if (found != tables_.end()) {
    std::rotate(tables_.begin(), found, found + 1);
  } else {
    if (tables_.size() == kMostInMemory) tables_.pop_back();
    const CageTableNews news{.progress =
                                 [&](double share) {
                                   if (share == 0) require_cage_memory(nominal_);
                                   show_progress(what, share);
                                 },
                             .warning = [](const std::string& text) { spdlog::warn("{}", text); }};
    tables_.emplace_front(point, make_scene_cage_table(nominal_, point, cage_cache_folder(), news));
  }
  return tables_.front().second;
}

}  // namespace cagetol
