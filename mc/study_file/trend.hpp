// What a source claims about a quantity between two levels of a dimension.
#pragma once

#include <string>

namespace cagetol {

struct Trend {
  std::string claim;        ///< in words
  std::string quantity;     ///< of interest
  std::string key;          ///< scene key that varies by lot
  double from = 0, to = 0;  ///< lot deviations, in the key's unit
  std::string expected;     ///< of the quantity on the way: rises, falls, level, unclear
  double by_share = 0;      ///< by how much, as a share of its mean at `from`
  double by_value = 0;      ///< by how much, in its unit
  std::string source;       ///< where the claim is made
};

}  // namespace cagetol
