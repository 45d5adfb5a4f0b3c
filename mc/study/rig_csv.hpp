// What a rig has measured, in a CSV file (measurement_csv.hpp): columns radial_N, speed_rpm and one
// of cage_rpm and cage_order, one row for each load and speed. Headings may give another unit.
#pragma once

#include <string>
#include <vector>

namespace cagetol {

/// One row of the file.
struct RigMeasurement {
  int line;            ///< in the file
  double radial_load;  ///< [N]
  double speed;        ///< of the inner ring; the outer one stands still [r/min]
  double cage_order;   ///< speed of the cage over that of the inner ring
};

/// Rows in the order of the file. Throws InputError with file, line and column for columns that are
/// missing, unknown or given twice, for text, and for what no bearing does: negative loads and
/// speeds, a shaft at rest, a cage faster than the ring that drives it.
std::vector<RigMeasurement> read_rig_csv(const std::string& path, bool decimal_comma = false);

}  // namespace cagetol
