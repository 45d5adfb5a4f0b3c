// An outcome as simulate and replay print it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "src/quantities/outcome.hpp"

namespace cagetol {

/// {"status", "reason", "qoi": {quantity: number or null}, "units": {quantity or field: unit},
/// "run": {field: number}}.
nlohmann::ordered_json outcome_json(const Outcome& outcome);

/// One line of a table.
std::string value_line(const std::string& key, double value, const std::string& unit);

/// Quantities and run, one line each with unit.
std::string outcome_table(const Outcome& outcome);

}  // namespace cagetol
