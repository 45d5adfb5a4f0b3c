// Measured parts of a CSV file as deviations of one key, with the cage that each belongs to.
//
// Pockets of a cage are alike, because one tool made them. Drawn one by one they would average out:
// what they share, which moves clearance and slip of a cage, would be divided by sqrt(Z).
#pragma once

#include <string>
#include <vector>

#include "distributions/law.hpp"
#include "src/input/key_table.hpp"

namespace cagetol {

/// How a study states a file of measurements.
struct StatedFile {
  std::string file, column, decimal = ".", missing = "refuse";
  std::string group;       ///< column that names the cage of each part
  bool ungrouped = false;  ///< the study says that parts share nothing
  bool fitted = false;     ///< normal laws are fitted, else what was measured is drawn
  bool centred = false, resample = false;
  std::vector<double> exclude;  ///< lines
};

/// What measurements are held against: near the nominal value they are sizes, and groups have as
/// many parts as the cage has pockets. 0: neither is known.
struct MeasuredKey {
  double nominal = 0;
  std::size_t pockets = 0;

  bool is_size(double value) const;
};

/// Measured deviations in the unit of their key, line by line.
struct MeasuredParts : StatedFile {
  std::string hash;                  ///< of the bytes of the file
  double offset = 0;                 ///< mean deviation from the nominal value, as measured
  std::vector<std::string> names;    ///< of the cages, in the order of the file
  NumberList values, cage;           ///< deviation of each part, and its cage from 0
  NumberList gaps;                   ///< parts without a value, from 0
  std::vector<std::string> remarks;  ///< on single lines, and where cages are few

  bool is_grouped() const { return !group.empty(); }
  /// By cage and pocket; NaN without a value. Throws InputError where a cage has none.
  std::vector<std::vector<double>> by_cage() const;
};

/// How a resolved study has them.
const KeyTable<MeasuredParts>& measured_keys();

/// From the bytes of the file `path`, for the law `key`. Throws InputError for a law of pockets on
/// a file that may have groups, where the study does not say so, and where groups have another
/// number of parts than the cage has pockets.
MeasuredParts read_measured_parts(const std::string& bytes, const std::string& path,
                                  const StatedFile& stated, const std::string& key,
                                  const std::string& unit, const MeasuredKey& of);

/// What the pockets of a cage share, and what each has by itself: as measured or fitted. Of parts
/// that share nothing only the latter.
struct MeasuredLaws {
  Law lot, pocket;
};
MeasuredLaws laws_of(const MeasuredParts& parts);

/// Deviations of `pockets` pockets of the cage at `place` in [0, cages). A pocket without a value
/// has that of the next one that has one. A cage with another number of pockets goes round: the
/// fraction of the place says where it begins.
std::vector<double> cage_at(const std::vector<std::vector<double>>& cages, double place,
                            std::size_t pockets);

/// Where the laws come from, and what is weak about that.
std::vector<std::string> measured_notes(const MeasuredParts& parts, const std::string& key,
                                        const std::string& unit);

}  // namespace cagetol
