// What the settings of a study's model are worth: DIR/ladder-refine/ladder.json beside study.h5,
// written by `cagetol ladder --refine`.
#pragma once

#include <filesystem>

#include "analysis/fidelity/error_budget.hpp"
#include "analysis/report/json_parts.hpp"

namespace cagetol {

inline constexpr const char* kRefiningLadderFolder = "ladder-refine";

/// The file's content; null where there is none that can be read as JSON. Whose it is, the chapter
/// says (error_budget_json).
Json read_refining_ladder(const std::filesystem::path& sweep_directory);

/// A number of the file, NaN where it is null; and one with its interval.
double known(const Json& value);
Estimate estimate_of(const Json& entry, const char* value);

/// What each refined setting does to the mean of a quantity.
std::vector<RefinedShift> refined_shifts(const Json& ladder, const std::string& quantity);

/// Known bias of a quantity's mean in `study`: sum of the magnitudes of the resolved errors of its
/// settings. NaN where the ladder is null, refines nothing, or was climbed for another study.
double known_bias(const Json& ladder, const StudyData& study, const std::string& quantity);

}  // namespace cagetol
