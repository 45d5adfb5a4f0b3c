// What a scene must say about oil, and the temperatures that a heat balance finds.
// Keys of lubrication without effect: scene_conditions.hpp.
#pragma once

#include <string>

#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// The error for a scene without lubrication.model. The message begins with `who`, for example "a
/// dynamic scene must say".
InputError no_word_of_oil(const std::string& who, const std::string& file);

/// Throws InputError for a temperature, or a distribution of one, that a file gives beside
/// temperature.balance = true, which finds it.
void refuse_given_temperatures(const Scene& scene, const toml::table& root,
                               const std::string& file);

/// Takes the temperatures out that `below`, a scene's table, gives, where `above`, laid over it,
/// sets temperature.balance = true. Does nothing where `below` was written by the program.
void leave_temperatures_to_balance(toml::table& below, const toml::table& above);

}  // namespace cagetol
