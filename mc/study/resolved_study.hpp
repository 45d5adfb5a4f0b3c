// A study with everything written out: what study.h5 stores and analysis reads (mc/README.md lists
// the keys).
#pragma once

#include <toml++/toml.h>
#include <string>

#include "mc/study/study.hpp"

namespace cagetol {

/// The study as a TOML document, every key with its value.
toml::table resolved_table(const Study& study);

/// Of a resolved text what moves runs: studies that agree in it have the same runs to the bit. Left
/// out are names and notes, what runs are judged by (limits, target, confidence, costs, shares of
/// failures), budgets, and the way to the model, which the scene holds as it was decided.
std::string identity_text(const std::string& resolved_toml);

/// Takes the decision of fidelity = "auto" out of a resolved document; empty where there is none.
FidelityDecision take_fidelity_decision(toml::table& root);

/// Turns a resolved document back into the form that users write: inputs become distributions of
/// the scene. Does nothing to a document that is not resolved. Throws InputError.
void unresolve(toml::table& root, const std::string& file);

}  // namespace cagetol
