// A study with everything written out: what study.h5 stores and analysis reads (mc/README.md lists
// the keys).
#pragma once

#include <toml++/toml.h>
#include <string>

#include "mc/study.hpp"

namespace cagetol {

/// The study as a TOML document, every key with its value.
toml::table resolved_table(const Study& study);

/// Turns a resolved document back into the form that users write: inputs become distributions of
/// the scene. Does nothing to a document that is not resolved. Throws InputError.
void unresolve(toml::table& root, const std::string& file);

/// 64-bit FNV-1a (Fowler, Noll, Vo) as 16 hex digits.
std::string hash_text(const std::string& text);

}  // namespace cagetol
