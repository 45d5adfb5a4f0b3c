// The tolerances in question: dimensions, what their tolerances cost, and candidates.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cagetol {

/// What a tolerance costs: widths in mm, ascending, and costs in any one currency.
using CostTable = std::vector<std::pair<double, double>>;

struct ToleranceDimension {
  std::string key;
  double tolerance_width_mm = 0;  ///< full width to which the laws of the study belong
  /// "IT9", "H9", "js9", deviations "+0.1/-0.02", or a tolerance width in mm.
  std::vector<std::string> candidates = {};
  std::vector<double> centres =
      {};               ///< candidate nominal values, in the key's unit; empty: its own
  CostTable cost = {};  ///< empty: not stated
};

/// One combination of candidate tolerances and centres, in the order of the study's dimensions.
struct Candidate {
  std::vector<double> tolerance_widths_mm;
  std::vector<std::string> grades;  ///< as the study names it; "" where it is a width in mm
  std::vector<double> scales;       ///< tolerance / tolerance_width_mm
  /// Centre less the study's nominal value, in the key's unit; empty: the centres are not moved.
  std::vector<double> shifts = {};
  /// Middle of the tolerance zone less its centre, in the key's unit; empty: zones are symmetric.
  std::vector<double> middles = {};

  double centre_shift(std::size_t dimension) const {
    return shifts.empty() ? 0 : shifts[dimension];
  }
  double middle(std::size_t dimension) const { return middles.empty() ? 0 : middles[dimension]; }
  /// By which the laws are moved.
  double shift(std::size_t dimension) const { return centre_shift(dimension) + middle(dimension); }
  std::vector<double> all_shifts() const;
};

/// Limits of size less the nominal value [mm].
struct Deviations {
  double upper = 0, lower = 0;
};

/// Of "+0.1/-0.02"; empty for any other form, and where the upper one is not above the lower one.
std::optional<Deviations> deviations_of(const std::string& name);

/// Middle of a tolerance zone less its nominal value [mm], by a candidate's name and width.
double zone_middle(const std::string& name, double tolerance_width_mm);

/// As a drawing has it, behind the nominal size: "+0.1/-0.02 mm", "H9 (+0.036/0 mm)",
/// "±0.018 mm (IT9, js9)"; grade as in Candidate.
std::string drawing_text(const std::string& grade, double tolerance_width_mm);

/// True where grades of ISO 286 mean something: a diameter, width or length in mm. A clearance, a
/// radius, an offset or a layer is no size; its tolerances are given in mm.
bool is_size(const std::string& key);

}  // namespace cagetol
