// What each mechanism of a bearing costs of a right-hand side: what that gets cheaper by without
// it.
#pragma once

#include <string>
#include <vector>

#include "src/integration/system.hpp"

namespace cagetol {

/// A part of a cost, and its share of the whole.
struct CostPart {
  std::string name;
  double share = 0;
};

/// Of the mechanisms that the bearing has, at a state (noise may make little of it negative).
std::vector<CostPart> mechanism_parts(double t, const double* y, const System& system);

}  // namespace cagetol
