// Keys that a user may try for what no scene can say, with the reason.
#pragma once

#include <string>

#include "src/input/toml_file.hpp"

namespace cagetol {

/// Throws InputError for a key that speaks of rows of rollers or of a split cage; else does
/// nothing.
void refuse_unmodelled_key(const TomlLeaf& leaf, const std::string& file);

}  // namespace cagetol
