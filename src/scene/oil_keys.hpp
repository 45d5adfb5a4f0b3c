// What lubrication.model makes of the other keys about oil. "film" has films of its own at every
// contact: it refuses the keys film.* and cage.guide_film*, and names the successor of each. With
// "none" the other keys of lubrication do nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/input/input_error.hpp"
#include "src/input/toml_file.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// The error for a scene without lubrication.model: `who` must say whether there is oil in the
/// bearing.
InputError no_word_of_oil(const std::string& who, const std::string& file);

/// What to give instead of a key that `scene` refuses because of its lubrication.model; empty: the
/// key is not refused.
std::string successor_of(const Scene& scene, std::string_view key);

/// Throws InputError where `root`, the file of `scene`, gives a key that has a successor; the
/// remedy names all of them.
void refuse_replaced_keys(const Scene& scene, const toml::table& root, const std::string& file);

/// The keys of a dry scene's lubrication that differ from their default and do nothing.
std::vector<std::string> idle_oil_keys(const Scene& scene);

}  // namespace cagetol
