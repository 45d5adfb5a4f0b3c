// A number with its interval.
#pragma once

#include <limits>

namespace cagetol {

inline constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Value with the ends of its interval; NaN where there is none.
struct Estimate {
  double value = kUndefined;
  double lower = kUndefined;
  double upper = kUndefined;
};

}  // namespace cagetol
