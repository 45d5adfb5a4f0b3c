// The pockets of one cage in a CSV file: columns width_mm, length_mm, pitch_mrad and
// squareness_mrad (or these names with another unit, measurement_csv.hpp), one row for each pocket,
// each value a deviation from the undeviated pocket.
#pragma once

#include <string>
#include <vector>

#include "src/cage/mesh/cage_mesh.hpp"

namespace cagetol {

/// Deviations in the order of the rows. Throws InputError with file, line and column, and where the
/// rows are not as many as the cage has pockets.
std::vector<PocketDeviation> read_pocket_deviations(const std::string& path, long pocket_count,
                                                    bool decimal_comma = false);

}  // namespace cagetol
