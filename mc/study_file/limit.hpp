// A bound on a quantity of interest that every cage must keep.
#pragma once

#include <cmath>
#include <optional>
#include <string>

namespace cagetol {

/// At least one of minimum and maximum is given.
struct Limit {
  std::string quantity;
  std::optional<double> minimum = {}, maximum = {};  ///< in the quantity's unit
  std::string source = {};                           ///< where the bound comes from
  double cage_revolutions = 0;  ///< of the window it is meant for; 0: not stated
  /// The maximum is what the nominal bearing has under this many times the maker's minimum load
  /// (mc/study/nominal_limits.hpp).
  std::optional<double> minimum_loads = {};
};

/// Whether a value is within; one that is not a number is not.
inline bool meets(const Limit& limit, double value) {
  return value >= limit.minimum.value_or(-HUGE_VAL) && value <= limit.maximum.value_or(HUGE_VAL);
}

}  // namespace cagetol
