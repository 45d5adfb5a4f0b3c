// Keys that do nothing in a scene, because its model leaves out what they describe: the rows of
// scene_keys.cpp say where.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

/// A sentence for each reason with the keys that do nothing for it: of those that may be left out,
/// whose value is not the default or which `varies` names (none if null).
std::vector<std::string> idle_notes(
    const Scene& scene, const std::function<bool(const std::string& key)>& varies = nullptr);

}  // namespace cagetol
