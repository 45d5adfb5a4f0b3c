#include "mc/study_file/shipped_file.hpp"

namespace cagetol {

std::filesystem::path shipped_file(const std::string& path) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto installed = program.parent_path().parent_path() / "share/cagetol" / path;
  if (!error && !program.string().starts_with(CAGETOL_BINARY_DIR "/")) return installed;
  return std::filesystem::path(CAGETOL_SOURCE_DIR) / path;
}

}  // namespace cagetol
