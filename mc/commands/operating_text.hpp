// The operating point of a scene (src/quantities/operating_point.hpp) as commands print it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "src/quantities/operating_point.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// Warnings, one line each, then the table, one line each with unit.
std::string operating_table(const Scene& scene);

/// What a duty over time does, its phases, and how long a run is: instants, speeds and loads of the
/// table, settling and measuring. Empty where operation is constant.
std::string duty_text(const Scene& scene);

/// {"warnings": [text], "values": {key: number or null}, "units": {key: unit}, "with_slip":
/// the orders again at this slip of the cage}.
nlohmann::ordered_json operating_json(const Scene& scene, double slip);

/// Whether the row is a multiple of the shaft's speed, which slip changes.
bool is_order(const OperatingRow& row);

}  // namespace cagetol
