// The keys of a study file. [scene] holds the scene's keys (src/reading/scene_keys.hpp).
#pragma once

#include <string>
#include <vector>

#include "mc/study/study.hpp"
#include "src/input/key_table.hpp"

namespace cagetol {

/// The plain keys: one value each.
const KeyTable<Study>& study_keys();

/// Keys of one [[limit]], one [[tolerance.dimension]], one [[correlation]] and one [[assumption]].
const std::vector<KeyInfo>& limit_keys();
const std::vector<KeyInfo>& dimension_keys();
const std::vector<KeyInfo>& correlation_keys();
const std::vector<KeyInfo>& assumption_keys();
const std::vector<KeyInfo>& operating_point_keys();

/// Whether `name` is the first part of a key of a study file ("tolerance", "limit", "scene", ...),
/// `name` itself apart: scenes have that too.
bool is_study_section(const std::string& name);
/// Likewise of a scene.
bool is_scene_section(const std::string& name);

}  // namespace cagetol
