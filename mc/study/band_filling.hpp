// How the parts of a study fill the band of a dimension that gets a tolerance, and what is to fit
// into the smallest of them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

struct BandFilling {
  std::string key;
  double band_mm = 0;  ///< full width that the laws belong to
  /// NaN where pockets have different ones [mm].
  double nominal_mm = std::numeric_limits<double>::quiet_NaN();
  double deviation_mm = 0;  ///< standard deviation of one part, lot and pocket together
  /// Cp = band/(6 deviation). That of every candidate, because its scatter scales with its band.
  double capability = 0;
  bool within = false;      ///< the laws end inside their band: no part lies outside
  std::string counterpart;  ///< what is to fit: "the roller's diameter"; empty where nothing is
  double counterpart_mm = std::numeric_limits<double>::quiet_NaN();
};

/// Of each dimension that gets a tolerance.
std::vector<BandFilling> band_fillings(const Study& study);

/// Warnings of laws of which so many parts lie outside their band that the band cannot be theirs.
std::vector<std::string> band_warnings(const Study& study);
/// Of candidates whose smallest part takes no roller: from which band on.
std::vector<std::string> band_notes(const Study& study);

}  // namespace cagetol
