// The bytes of a study file, read once and proven sound before HDF5 sees them.
#pragma once

#include <filesystem>
#include <string>

namespace cagetol {

/// Locks do not matter: a file that is being written does not match its seal. Throws
/// StudyFileError, which tells apart: missing, no permission, cut short, damaged, without seal,
/// locked, no HDF5 file.
std::string read_study_bytes(const std::filesystem::path& file);

}  // namespace cagetol
