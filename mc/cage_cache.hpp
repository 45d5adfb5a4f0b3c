// Cage tables take long to make and depend on the scene alone: they are kept between runs.
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "src/cage/scene_cage.hpp"

namespace cagetol {

/// Where cage tables are kept: $CAGETOL_CACHE, else $XDG_CACHE_HOME/cagetol, else
/// $HOME/.cache/cagetol, else a folder of this user's where the system keeps scratch files.
std::filesystem::path cage_cache_folder();

/// The tables of a scene's flexible cage. Each is read from that folder, or made and kept there;
/// while it is made stderr says how far it is. A folder that cannot be written costs a warning. For
/// one thread.
class CageTables {
 public:
  /// Throws InputError where the scene's undeviated cage is impossible.
  explicit CageTables(const Scene& nominal);

  /// The grid point whose table serves a sample of the scene; the sample alone decides.
  GridPoint point_of(const Scene& sample) const { return table_point(nominal_, sample); }
  /// That table. The last ones asked for, 4 MB each, stay in memory.
  std::shared_ptr<const CageTable> of(const Scene& sample);

  /// Makes the tables of these points before samples ask for them: this rank every `ranks`-th of
  /// them. A signal to stop ends it between two tables.
  void make(const std::set<GridPoint>& points, int rank, int ranks);

 private:
  std::shared_ptr<const CageTable> table(const GridPoint& point, const std::string& what);

  Scene nominal_;
  std::deque<std::pair<GridPoint, std::shared_ptr<const CageTable>>> tables_;  ///< last used first
};

}  // namespace cagetol
