// DIR/cage_peak.json: the stress field at the worst instant of a sweep's most stressed sample.
#pragma once

#include <filesystem>

namespace cagetol {

/// Runs the most stressed sample of a sweep of flexible cages again, recovers the whole stress
/// field at its peak and writes it beside study.h5, unless a file of that sample is there already.
/// A report lives without the file: what prevents it is a warning on stderr.
void update_cage_peak(const std::filesystem::path& sweep_directory);

}  // namespace cagetol
