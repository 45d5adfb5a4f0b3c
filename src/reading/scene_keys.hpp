// Every key of a scene file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/input/key_table.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// All keys, in the order of --dump-default and of inputs/KEYS.md.
const KeyTable<Scene>& scene_keys();

/// A scene with a value for every key: defaults for optional keys, the NU 205 for required ones.
Scene example_scene();

/// Reads a scene from TOML. Optional keys that are missing keep their defaults. Missing required
/// keys are listed in one error. Geometry, load and speed are required for every model, because the
/// model ladder changes the model of a scene. Unknown keys are errors that name the nearest key. If
/// a key holds a distribution its `nominal` is read; without one the key counts as missing. `file`
/// names the source in messages. Checks ranges and the scene as a whole (check_scene). Throws
/// InputError.
Scene read_scene(const toml::table& root, const std::string& file);

/// True if a table of a scene is a distribution: it has at least one of the entries `law`, `lot`,
/// `pocket`, `noise` and `nominal`.
bool is_distribution(const toml::table& table);

/// Whether a text may name a phase or an operating point: letters, digits, _ and -, 40 at most.
bool is_label(std::string_view text);

/// Checks the scene as a whole: the nominal roller fits the nominal pocket, the cage fits between
/// the rings, the pockets fit the pitch. Throws InputError with `file`, the conflicting keys and
/// their values; `root` gives the line of the first one. Not used for samples, where a pocket that
/// is too small is an outcome (jammed).
void check_scene(const Scene& scene, const std::string& file, const toml::table* root = nullptr);

/// What is probably not meant, one sentence each: sizes far from those of bearings, values that
/// their own assumption excludes, and what the model takes more simply than the scene's geometry.
std::vector<std::string> scene_doubts(const Scene& scene);

}  // namespace cagetol
