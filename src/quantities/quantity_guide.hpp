// What a quantity of interest needs of the model to be computed, and what it is used for: the guide
// that `cagetol quantities` prints beside definition and unit.
#pragma once

#include <string>

#include "src/scene/scene.hpp"

namespace cagetol {

struct QuantityGuide {
  const char* needs;              ///< switches of the scene, in words
  bool (*defined)(const Scene&);  ///< the same as a condition: else the quantity is NaN
  const char* use;                ///< typical use
};

/// Of a quantity of quantity_table(). Throws std::logic_error for any other key.
QuantityGuide quantity_guide(const std::string& key);

}  // namespace cagetol
