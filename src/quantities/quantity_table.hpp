// The quantities of interest of a run, in the order of all files and tables. A quantity is one row
// of quantity_rows.hpp; all that is known of it stands there.
#pragma once

#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

/// Whether runs of scenes that meet a need give a number.
enum class Given { always, where_the_cage_turns, perhaps };

/// What a quantity needs of a scene (quantity_needs.cpp).
struct Need {
  const char* text;           ///< switches of the scene, in words
  bool (*met)(const Scene&);  ///< the same as a condition: else the quantity is NaN
  Given given = Given::always;
};

/// What a quantity is over the window of a run, and over several operating points.
enum class Kind {
  mean,     ///< over the whole window, or at its end; over points none
  power,    ///< mean power or torque over the whole window; mean by the points' weights
  peak,     ///< largest value, high quantile, or utilisation by it; over points the largest
  minimum,  ///< smallest value; over points the smallest
  place,    ///< where the row's peak is; that of the point at which it is largest
};
/// Whether it depends on the time that it is taken over (window.peak_revolutions).
constexpr bool is_extreme(Kind kind) {
  return kind != Kind::mean && kind != Kind::power;
}

struct JudgedRun;
struct ValueRange {
  double low, high;
};

/// Values beyond are impossible: a run that gives one has failed (quantity_bounds.hpp).
struct Bound {
  ValueRange (*range)(const JudgedRun&);  ///< in the quantity's unit
  const char* reason;                     ///< follows "impossible: " in the message
  const char* remedy =
      "tighten integration.tolerance, and check the scene's stiffnesses and speeds";
};

struct Quantity {
  const char* key;   ///< name in study.h5 and --json output, unit as suffix
  const char* unit;  ///< "-" for a ratio
  Kind kind;
  const Need& need;
  const Bound& bound;
  const char* use;         ///< typical use
  const char* definition;  ///< one sentence, printed in reports
  const char* peak = "";   ///< key of the peak that a mean or quantile cannot exceed; of a place
};

const std::vector<Quantity>& quantity_table();

/// Position of `key` in quantity_table(), or -1.
int quantity_index(const std::string& key);

/// The quantity of a name that may have a label (quantity_labels.hpp). Throws std::out_of_range.
const Quantity& quantity_named(const std::string& name);

}  // namespace cagetol
