// What the bearing of a study is, for the page of its report that shows the operating point.
#pragma once

#include <filesystem>

#include "analysis/report/json_parts.hpp"
#include "src/scene/scene.hpp"

namespace cagetol {

/// {groups: [{title, entries: [{name, text} or {name, value, unit}]}], model: [sentence], points,
/// assumed: {KEY: {value, unit, automatic}}, warnings, strength, section, drawing} of the nominal
/// scene; `section` has what a drawing of the bearing needs, in mm, `drawing` is
/// pocket_drawing_json() of pocket 0. Warnings of heat judge the mean power of the samples.
/// {problem: why} where this program cannot read the study that the file stores.
Json bearing_facts(const std::filesystem::path& study_file);

}  // namespace cagetol
