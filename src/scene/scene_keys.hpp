// Every key of a scene file.
#pragma once

#include <string>

#include "src/input/key_table.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

const KeyTable<Scene>& scene_keys();

/// Reads a scene from TOML. Keys not given keep their defaults; unknown keys are errors that name the nearest known key.
/// `file` names the source in messages. Checks ranges and the scene as a whole (check_scene). Throws InputError.
Scene read_scene(const toml::table& root, const std::string& file);

/// Consistency beyond single keys: nominal roller fits nominal pocket, cage fits between the rings, pockets fit the pitch.
/// Throws InputError naming `file` and the keys that disagree. Skipped for samples: there a pocket too small is a jam outcome.
void check_scene(const Scene& scene, const std::string& file);

}  // namespace cagetol
