// Bounds of the quantities of interest that hold for any motion. A run outside its bounds is a
// failed sample, even if all watches are satisfied.
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
  /// True if a run of this kind must give a number. A run without one has failed.
  bool (*expected)(const PlausibleReach& reach);
  PlausibleRange (*range)(const PlausibleReach& reach);
  const char* reason;  ///< why larger values cannot occur; follows "impossible: " in the message
  const char* remedy;
};
const std::vector<PlausibleRow>& plausible_rows();

/// Two quantities of which the first cannot exceed the second.
struct PlausibleOrder {
  const char *lesser, *greater;
  const char* reason;
};
const std::vector<PlausibleOrder>& plausible_orders();

/// A message about the first impossible value of `quantities` (in the order of quantity_table())
/// with name, value, bound, reason and remedy; empty if all values are possible.
std::string find_implausible(const PlausibleReach& reach, const std::vector<double>& quantities);

}  // namespace cagetol
