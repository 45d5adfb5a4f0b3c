// The cheap runs beside a study: DIR/companion/study.h5, the study's first samples and many more on
// a cheaper rung of the model ladder (multifidelity = "auto").
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "analysis/study/study_data.hpp"

namespace cagetol {

inline constexpr const char* kCompanionFolder = "companion";

/// None where there is no such file, or not all of its runs are there yet. Throws StudyFileError
/// where it is damaged.
std::optional<StudyData> read_companion(const std::filesystem::path& sweep_directory);

/// Why these are not the study's own samples on another model; empty where they are.
std::string companion_problem(const StudyData& runs, const StudyData& companion);

}  // namespace cagetol
