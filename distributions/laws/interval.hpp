#pragma once

namespace cagetol {

/// Closed range of values; the ends may be infinite.
struct Interval {
  double lower = 0, upper = 0;
};

}  // namespace cagetol
