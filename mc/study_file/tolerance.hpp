// The tolerances in question: dimensions, what their tolerances cost, and candidates.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cagetol {

/// What a tolerance costs, in any one currency: a + b / tolerance^k (tolerance width in mm), or the
/// straight lines through a table.
struct CostCurve {
  double a = 0, b = 0, k = 1;
  std::vector<std::pair<double, double>>
      table;  ///< tolerance width in mm and cost, tolerances ascending; or empty
};

struct ToleranceDimension {
  std::string key;
  double tolerance_width_mm = 0;             ///< full width to which the laws of the study belong
  std::vector<std::string> candidates = {};  ///< "IT9", or a tolerance width in mm
  std::vector<double> centres =
      {};  ///< candidate nominal values, in the key's unit; empty: its own
  std::optional<CostCurve> cost = {};
};

/// One combination of candidate tolerances and centres, in the order of the study's dimensions.
struct Candidate {
  std::vector<double> tolerance_widths_mm;
  std::vector<std::string> grades;  ///< "" where the tolerance was given in mm
  std::vector<double> scales;       ///< tolerance / tolerance_width_mm
  /// Centre less the study's nominal value, in the key's unit; empty: the centres are not moved.
  std::vector<double> shifts = {};
  double shift(std::size_t dimension) const { return shifts.empty() ? 0 : shifts[dimension]; }
};

/// True where grades of ISO 286 mean something: a diameter, width or length in mm. A clearance, a
/// radius, an offset or a layer is no size; its tolerances are given in mm.
bool is_size(const std::string& key);

}  // namespace cagetol
