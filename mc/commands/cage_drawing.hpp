// The drawing of one pocket of a cage with its roller: lines and clearances, for the figure.
#pragma once

#include <string>

#include "analysis/report/json_parts.hpp"
#include "src/operation/operating_scene.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// {scene, pocket, clearances[], section, outside}; lengths in mm. Each clearance has the place in
/// a view that shows it; null values stand for clearances that nothing bounds.
Json pocket_drawing_json(const OperatingScene& scene, long pocket);

/// The clearances of that JSON as lines of text.
std::string clearances_text(const Json& drawing);

}  // namespace cagetol
