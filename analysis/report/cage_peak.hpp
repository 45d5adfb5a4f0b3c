// The stress field at the worst instant of a sweep's most stressed sample: DIR/cage_peak.json,
// written by whoever can run that sample again (mc/RESULTS_FORMAT.md says what is in it).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "analysis/report/json_parts.hpp"

namespace cagetol {

/// Id of the sample with the largest cage_stress_peak_MPa among those that are ok, the first of
/// equals. Nothing where no sample has any, as with a rigid cage.
std::optional<std::int64_t> most_stressed_sample(const StudyData& study);

std::filesystem::path cage_peak_file(const std::filesystem::path& sweep_directory);

/// The file's content; null where there is none, or where it belongs to another study, build or
/// sample than `study` holds now.
Json read_cage_peak(const std::filesystem::path& sweep_directory, const StudyData& study);

}  // namespace cagetol
