// The operating point of a scene (src/quantities/operating_point.hpp) as commands print it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "src/scene/scene.hpp"

namespace cagetol {

/// Warnings, one line each, then the table, one line each with unit.
std::string operating_table(const Scene& scene);

/// What a duty over time does, its phases, and how long a run is: instants, speeds and loads of the
/// table, the oscillation, settling and measuring. Empty where operation is constant.
std::string duty_text(const Scene& scene);

/// {"warnings": [text], "values": {key: number or null}, "units": {key: unit}}.
nlohmann::ordered_json operating_json(const Scene& scene);

}  // namespace cagetol
