// A study with everything written out: what study.h5 stores and analysis reads (mc/README.md lists
// the keys).
#pragma once

#include <toml++/toml.h>
#include <string>

#include "mc/study/study.hpp"

namespace cagetol {

/// The study as a TOML document, every key with its value.
toml::table resolved_table(const Study& study);

/// Takes the decision of fidelity = "auto" out of a resolved document; empty where there is none.
FidelityDecision take_fidelity_decision(toml::table& root);

/// Turns a resolved document back into the form that users write: inputs become distributions of
/// the scene. Does nothing to a document that is not resolved. Throws InputError.
void unresolve(toml::table& root, const std::string& file);

}  // namespace cagetol
