// What a quantity of interest cannot be, whatever the motion. A run outside these bounds is a
// failed sample: its number is no result, however well the watches look.
#pragma once

#include <string>
#include <vector>

#include "src/quantities/plausible_reach.hpp"

namespace cagetol {

struct PlausibleRange {
  double low, high;  ///< in the quantity's unit
};

/// One row for each quantity of quantity_table(), in any order.
struct PlausibleRow {
  const char* key;
  /// Whether a run of this kind must give a number: without one it has failed.
  bool (*expected)(const PlausibleReach& reach);
  PlausibleRange (*range)(const PlausibleReach& reach);
  const char* reason;  ///< why nothing lies beyond, following "impossible: "
  const char* remedy;
};
const std::vector<PlausibleRow>& plausible_rows();

/// Two quantities of which the first cannot exceed the second.
struct PlausibleOrder {
  const char *lesser, *greater;
  const char* reason;
};
const std::vector<PlausibleOrder>& plausible_orders();

/// Empty, or the first impossible value of `quantities` (in the order of quantity_table()): its
/// name, value and bound, why it is impossible, and a remedy.
std::string find_implausible(const PlausibleReach& reach, const std::vector<double>& quantities);

}  // namespace cagetol
