#include "tests/support/probe_folder.hpp"

#include <unistd.h>

#include <fstream>

namespace cagetol {

ProbeFolder::ProbeFolder() {
  const std::filesystem::path memory = "/dev/shm";
  path_ =
      (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
      ("cagetol-probe-" + std::to_string(getpid()));
  std::filesystem::create_directories(path_);
}

ProbeFolder::~ProbeFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ProbeFolder::write(const char* name, std::string_view bytes) const {
  const std::string file = (path_ / name).string();
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
  return file;
}

const ProbeFolder& probe_folder() {
  static const ProbeFolder made;
  return made;
}

}  // namespace cagetol
