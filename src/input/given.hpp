// Numbers that an input file may leave to the program.
#pragma once

#include <cmath>
#include <limits>

namespace cagetol {

/// "auto" in input files: computed from the rest of the scene.
inline constexpr double kAuto = std::numeric_limits<double>::quiet_NaN();
inline double given_or(double value, double otherwise) {
  return std::isnan(value) ? otherwise : value;
}

}  // namespace cagetol
