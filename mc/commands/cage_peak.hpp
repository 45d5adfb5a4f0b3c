// DIR/cage_peak.json: the stress field at the worst instant of a sweep's most stressed sample.
#pragma once

#include <filesystem>

namespace cagetol {

/// The last step of a sweep of flexible cages: runs its most stressed sample again, recovers the
/// whole stress field at its peak and writes it beside study.h5 for the report, unless a file of
/// that sample is there already. A report lives without the file: what prevents it is a warning on
/// stderr. A SignalWatch must live around it.
void update_cage_peak(const std::filesystem::path& sweep_directory);

}  // namespace cagetol
