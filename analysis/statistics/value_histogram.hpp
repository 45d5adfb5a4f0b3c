// Counts of a quantity in equal classes, wide enough to show its limits.
#pragma once

#include <span>
#include <vector>

namespace cagetol {

struct ValueHistogram {
  std::vector<double> edges;  ///< one more than counts
  std::vector<double>
      counts;  ///< runs in [edge i, edge i+1); the last class holds its upper edge too
};

/// Class width by Freedman and Diaconis, 2 IQR / n^(1/3), between 8 and 40 classes over the range
/// of the values. NaN is left out. All values equal: one class around them.
ValueHistogram value_histogram(std::span<const double> values);

}  // namespace cagetol
