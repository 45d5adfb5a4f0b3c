// Radial internal clearance of cylindrical roller bearings with cylindrical bore, unmounted: ISO
// 5753-1:2009, as makers' catalogues print it. Classes C2, CN (normal), C3 and C4, bores up to 250
// mm.
#pragma once

#include "src/input/choice.hpp"

namespace cagetol {

enum class ClearanceClass { C2, CN, C3, C4 };
constexpr auto spellings(ClearanceClass) {
  using enum ClearanceClass;
  return std::array{Spelling{C2, "C2"}, Spelling{CN, "CN"}, Spelling{C3, "C3"}, Spelling{C4, "C4"}};
}

struct ClearanceRange {
  double minimum = 0, most = 0;  ///< diametral [m]
};

/// Of a bore [m]. Throws std::domain_error beyond the table.
ClearanceRange clearance_range(ClearanceClass which, double bore);

}  // namespace cagetol
