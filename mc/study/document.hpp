// The title block of a report from a file of its own.
#pragma once

#include <map>
#include <string>

namespace cagetol {

/// The section [document] of a TOML file, a study's or one with nothing else: texts by the names of
/// its keys. Throws InputError where there is none, or a text is none of inputs/KEYS.md's.
std::map<std::string, std::string> read_document(const std::string& file);

}  // namespace cagetol
