// Numbers for JSON, which knows neither infinity nor "not a number".
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

namespace cagetol {

/// `value`, or null where it is not finite.
inline nlohmann::ordered_json json_number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace cagetol
