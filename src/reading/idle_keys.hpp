// Keys that do nothing in a scene, because its model leaves out what they describe.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "src/scene/scene.hpp"

namespace cagetol {

/// Why the key does nothing in this scene, for example `cage.model = "rigid"`; empty if it does
/// something. Of keys that do something in some scene only: titles and watches are none of these.
std::string why_idle(const Scene& scene, std::string_view key);

/// A sentence for each reason with the keys that do nothing for it: of those that may be left out,
/// whose value is not the default or which `varies` names (none if null).
std::vector<std::string> idle_notes(
    const Scene& scene, const std::function<bool(const std::string& key)>& varies = nullptr);

}  // namespace cagetol
