// Two keys of an operating point varied over a study: the cells of a map.
#pragma once

#include <string>
#include <vector>

#include "mc/study/study.hpp"

namespace cagetol {

struct MapAxis {
  std::string key;             ///< of a scene
  bool logarithmic = false;    ///< drawn so: with ":log", or where given values span a decade
  std::vector<double> values;  ///< ascending, in the key's unit
};

/// "KEY=A..B:N", "KEY=A..B:N:log" (N values, those between the ends rounded to four digits) or
/// "KEY=A,B,C". Throws InputError for what is neither, and for keys that an operating point cannot
/// set to these values.
MapAxis read_map_axis(const std::string& text, const Study& study);

/// The study with these values of the axes at its scene and at each of its operating points; points
/// that differ in nothing else become one, which has the limits of all, and one point alone is the
/// scene's. Temperatures of a balance and limits by the maker's minimum load are found anew. Throws
/// InputError.
Study study_at(const Study& study, const std::vector<MapAxis>& axes,
               const std::vector<double>& values);

}  // namespace cagetol
