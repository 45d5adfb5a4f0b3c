#pragma once

#include <filesystem>
#include <string>

namespace cagetol {

/// Replaces the file at once, by renaming. Throws StudyFileError with the reason: UnfinishedWrite
/// where the disk is full.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace cagetol
