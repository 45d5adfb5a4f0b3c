// Every key of a scene file.
#pragma once

#include <string>

#include "src/input/key_table.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// All keys, in the order in which they are dumped and listed.
const KeyTable<Scene>& scene_keys();

/// A scene with every key: the defaults of those that may be left out, and the NU 205 for those
/// that are required.
Scene example_scene();

/// Reads a scene from TOML. Keys not given keep their defaults; those that are required
/// (KeyRange::required: geometry, load and speed, whatever the model, because rungs of the model
/// ladder change the model of a scene) are named in one error when they are left out. Unknown keys
/// are errors that name the nearest known key. Where a key holds a distribution, its `nominal` is
/// read (absent: as if not given); drawing from it is the business of mc. `file` names the source
/// in messages. Checks ranges and the scene as a whole (check_scene). Throws InputError.
Scene read_scene(const toml::table& root, const std::string& file);

/// Whether a table in a scene is a distribution: it holds at least one of `law`, `lot`, `pocket`,
/// `noise`, `nominal`.
bool is_distribution(const toml::table& table);

/// Consistency beyond single keys: nominal roller fits nominal pocket, cage fits between the rings,
/// pockets fit the pitch. Throws InputError naming `file`, the keys that disagree and their values;
/// `root` gives the line of the first of them. Skipped for samples: there a pocket too small is a
/// jam outcome.
void check_scene(const Scene& scene, const std::string& file, const toml::table* root = nullptr);

}  // namespace cagetol
