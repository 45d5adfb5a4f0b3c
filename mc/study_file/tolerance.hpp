// The tolerances in question: dimensions, what their bands cost, and candidates.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cagetol {

/// What a tolerance costs, in any one currency: a + b / band^k (band in mm), or the straight lines
/// through a table.
struct CostCurve {
  double a = 0, b = 0, k = 1;
  std::vector<std::pair<double, double>> table;  ///< band in mm and cost, bands ascending; or empty
};

struct ToleranceDimension {
  std::string key;
  double band_mm = 0;                        ///< full width to which the laws of the study belong
  std::vector<std::string> candidates = {};  ///< "IT9", or a band in mm
  std::vector<double> centres =
      {};  ///< candidate nominal values, in the key's unit; empty: its own
  std::optional<CostCurve> cost = {};
};

/// One combination of candidate bands and centres, in the order of the study's dimensions.
struct Candidate {
  std::vector<double> bands_mm;
  std::vector<std::string> grades;  ///< "" where the band was given in mm
  std::vector<double> scales;       ///< band / band_mm
  /// Centre less the study's nominal value, in the key's unit; empty: the centres are not moved.
  std::vector<double> shifts = {};
  double shift(std::size_t dimension) const { return shifts.empty() ? 0 : shifts[dimension]; }
};

/// True where grades of ISO 286 mean something: a diameter, width or length in mm. A clearance, a
/// radius, an offset or a layer is no size; its bands are given in mm.
bool is_size(const std::string& key);

}  // namespace cagetol
