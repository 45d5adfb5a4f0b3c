// An outcome as simulate and replay print it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "src/outcome.hpp"

namespace cagetol {

/// {"status", "reason", "qoi": {quantity: number or null}, "run": {field: number}}.
nlohmann::ordered_json outcome_json(const Outcome& outcome);

/// Quantities and run, one line each with unit.
std::string outcome_table(const Outcome& outcome);

}  // namespace cagetol
