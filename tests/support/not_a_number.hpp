// The value that a failed run has in place of each quantity, for tests.
#pragma once

#include <limits>

namespace cagetol {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

}  // namespace cagetol
