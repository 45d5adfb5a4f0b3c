// How the peak force on the pockets follows the centre of a dimension, and where it is least.
//
// Lots scatter about the centres studied, so the runs fill the range between them. Their values y
// are fitted by least squares,
//   y = a_b + c1 u + c2 u^2 + c3 u^3,   u from -1 to 1 over the range of the centres,
// with a level a_b for every tolerance of the dimension, which forces follow too. The optimum is
// the u with the least fitted value. Its interval: lots drawn again (Resampling).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/resampling.hpp"

namespace cagetol {

inline constexpr const char* kCentreQuantity = "pocket_force_peak_N";

/// Runs whose lot lies nearest to one centre.
struct CentreMean {
  double centre = 0, mean = 0, standard_error = 0;
  std::size_t runs = 0;
};

struct CentreResponse {
  std::string key, unit;           ///< of the dimension
  std::string quantity_unit;       ///< of kCentreQuantity
  std::vector<CentreMean> means;   ///< by centre, ascending
  std::vector<double> at, fitted;  ///< curve over the range, at the mean level of the tolerances
  Estimate optimum;                ///< centre of minimum force, in the key's unit
  bool at_end = false;  ///< the interval reaches an end of the range: the optimum may lie beyond
};

/// Of a dimension with three or more centres; nothing where the quantity is missing or too few runs
/// have it. `runs` are first runs.
std::optional<CentreResponse> centre_response(const StudyData& runs, std::size_t dimension,
                                              const Resampling& resampling, double confidence);

}  // namespace cagetol
