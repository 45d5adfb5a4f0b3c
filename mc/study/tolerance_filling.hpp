// How the parts of a study fill the tolerance of a dimension that gets a tolerance, and what is to
// fit into the smallest of them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

struct ToleranceFilling {
  std::string key;
  double tolerance_width_mm = 0;  ///< full width that the laws belong to
  /// NaN where pockets have different ones [mm].
  double nominal_mm = std::numeric_limits<double>::quiet_NaN();
  double deviation_mm = 0;  ///< standard deviation of one part, lot and pocket together
  double mean_mm = 0;       ///< of the laws, beside the nominal value
  /// Pp = tolerance/(6 deviation), of all scatter. That of every candidate, because its scatter
  /// scales with its tolerance.
  double capability = 0;
  bool within = false;      ///< the laws end inside their tolerance: no part lies outside
  std::string counterpart;  ///< what is to fit: "the roller's diameter"; empty where nothing is
  double counterpart_mm = std::numeric_limits<double>::quiet_NaN();
};

/// Of each dimension that gets a tolerance.
std::vector<ToleranceFilling> tolerance_fillings(const Study& study);

/// Warnings of laws of which so many parts lie outside their tolerance that the tolerance cannot be
/// theirs.
std::vector<std::string> tolerance_warnings(const Study& study);
/// Of candidates whose smallest part takes no roller: from which tolerance on.
std::vector<std::string> tolerance_notes(const Study& study);

}  // namespace cagetol
