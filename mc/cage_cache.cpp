#include "mc/cage_cache.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "src/input/input_error.hpp"

namespace cagetol {
namespace {

/// An environment variable, empty where it is not set.
std::filesystem::path variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// One line that rewrites itself on a terminal; in a log only its beginning.
void show_progress(double share) {
  const bool terminal = ::isatty(STDERR_FILENO) != 0;
  if (!terminal && share > 0) return;
  fmt::print(stderr, "{}making the cage table, once for this cage: {:3.0f} %{}",
             terminal ? "\r" : "", 100 * share, !terminal || share >= 1 ? "\n" : "");
  std::fflush(stderr);
}

}  // namespace

std::filesystem::path cage_cache_folder() {
  if (const auto chosen = variable("CAGETOL_CACHE"); !chosen.empty()) return chosen;
  if (const auto cache = variable("XDG_CACHE_HOME"); !cache.empty()) return cache / "cagetol";
  if (const auto home = variable("HOME"); !home.empty()) return home / ".cache" / "cagetol";
  return std::filesystem::temp_directory_path() / fmt::format("cagetol-{}", ::getuid());
}

std::shared_ptr<const CageTable> kept_cage_table(const Scene& scene) {
  const CageDimensions cage = cage_dimensions(scene.cage, scene.bearing.roller_count);
  const std::vector<PocketDeviation> none(static_cast<std::size_t>(cage.pocket_count));
  if (const auto fault = cage_fault(cage, none))
    throw InputError({}, "cage", "", "the cage without deviations is impossible: " + fault->reason,
                     "check the dimensions of [cage] and the number of rollers");
  const CageTableNews news{.progress = show_progress,
                           .warning = [](const std::string& text) { spdlog::warn("{}", text); }};
  return make_scene_cage_table(scene, cage_cache_folder(), news);
}

}  // namespace cagetol
