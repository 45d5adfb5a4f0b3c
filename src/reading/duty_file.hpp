// Reads what TOML keys alone do not say of a duty over time: the CSV file that holds its columns,
// and phases as a list of tables.
#pragma once

#include <string>

#include "src/input/toml_file.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// Fills the columns of `table` from the CSV that it names and empties its `file`. `node` holds the
/// name: paths are relative to the file that it stands in, of --set to the current folder. Throws
/// InputError with file, line, column and value.
void read_duty_file(const toml::node& node, const std::string& file, DutyTable& table);

/// From [[phase]] with name, from_s and to_s. Throws InputError.
void read_phases(const toml::node& node, const std::string& file, Phases& phases);

}  // namespace cagetol
