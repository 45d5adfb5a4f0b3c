// The layers of a study's text: its scene file, what the study says on top of it, and settings from
// the command line.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

namespace cagetol {

/// The study as one table, its scene file merged below `scene`, settings applied. A scene file
/// becomes a study of one row. Every node remembers the file and line that it came from. Throws
/// InputError.
toml::table study_layers(const std::string& path, const std::vector<std::string>& settings);

/// The same for a table that is parsed already; `path` names it and is where relative paths start.
toml::table study_layers(toml::table root, const std::string& path,
                         const std::vector<std::string>& settings);

}  // namespace cagetol
