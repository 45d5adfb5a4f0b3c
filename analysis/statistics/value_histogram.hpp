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

/// Class width of Freedman and Diaconis, 2 IQR / n^(1/3), but 8 to 40 classes over the range of the
/// values. NaN is left out. Equal values are in one class.
ValueHistogram value_histogram(std::span<const double> values);

}  // namespace cagetol
