// What the settings of a study's model are worth: DIR/ladder-refine/ladder.json beside study.h5,
// written by `cagetol ladder --refine`.
#pragma once

#include <filesystem>

#include "analysis/report/json_parts.hpp"

namespace cagetol {

inline constexpr const char* kRefiningLadderFolder = "ladder-refine";

/// The file's content; null where there is none that can be read as JSON. Whose it is, the chapter
/// says (error_budget_json).
Json read_refining_ladder(const std::filesystem::path& sweep_directory);

}  // namespace cagetol
