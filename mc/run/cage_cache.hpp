// Cage tables take long to make and depend on the scene alone: they are kept between runs.
#pragma once

#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "mc/host/private_folder.hpp"
#include "src/cage/table/scene_cage.hpp"
#include "src/simulate.hpp"

namespace cagetol {

/// Where cage tables are kept: $CAGETOL_CACHE, else $XDG_CACHE_HOME/cagetol, else
/// $HOME/.cache/cagetol, else a folder of this user's where the system keeps scratch files.
std::filesystem::path cage_cache_folder();

/// make_scene_cage_table() of the scene's own cage; throws InputError where its finite elements
/// cannot be solved.
std::shared_ptr<const CageTable> made_cage_table(const Scene& nominal,
                                                 const TableProgress& progress = {});

/// The tables of a scene's flexible cage. Each is read from that folder, or made and kept there;
/// while it is made stderr says how far it is. A table is read only where this very program wrote
/// it and every bit is as it was written; a damaged one costs a warning and is made again. A folder
/// that cannot be written, or that others may write to, costs one warning and is not used. For one
/// thread.
class CageTables {
 public:
  /// Throws InputError where the scene's undeviated cage is impossible.
  explicit CageTables(const Scene& nominal);

  /// The grid point whose table serves a sample of the scene; the sample alone decides.
  GridPoint point_of(const Scene& sample) const { return table_point(nominal_, sample); }
  /// That table. The last ones asked for, 4 MB each, stay in memory. Throws InputError where the
  /// scene's own cage cannot be solved, and UnsolvedCage where that of a sample far from it cannot.
  std::shared_ptr<const CageTable> of(const Scene& sample);
  /// That table as simulate() takes it; where a sample's cage cannot be solved, why: the run fails.
  SimulateOptions options_of(const Scene& sample);

  /// Makes the tables of these points before samples ask for them: this rank every `ranks`-th of
  /// them. A signal to stop ends it between two tables. Throws as of() does, but leaves a cage out
  /// that is not the scene's own and cannot be solved: its samples will fail.
  void make(const std::set<GridPoint>& points, int rank, int ranks);

 private:
  std::shared_ptr<const CageTable> table(const GridPoint& point, const std::string& what);
  std::shared_ptr<const CageTable> make(const GridPoint& point, const std::string& what);
  std::string file_name(const GridPoint& point) const;
  /// What a kept table must say of itself: format, key and build.
  std::string head(const GridPoint& point) const;
  void open_folder();
  /// Said once; of the ranks of a sweep by the first.
  void warn_of_folder(const std::string& problem, const std::string& remedy);
  /// The kept table; nullptr where there is none that can be used.
  std::shared_ptr<const CageTable> read(const GridPoint& point);
  void keep(const GridPoint& point, const CageTable& table);

  Scene nominal_;
  std::map<GridPoint, std::string> unsolved_;  ///< and why
  std::optional<PrivateFolder> folder_;
  bool folder_was_opened_ = false, speaks_of_folder_ = true;
  std::deque<std::pair<GridPoint, std::shared_ptr<const CageTable>>> tables_;  ///< last used first
};

}  // namespace cagetol
