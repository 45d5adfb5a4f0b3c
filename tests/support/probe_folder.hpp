// A folder of this process for files that a probe reads, in memory where the system has such a
// place.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cagetol {

class ProbeFolder {
 public:
  ProbeFolder();
  ProbeFolder(const ProbeFolder&) = delete;
  ProbeFolder& operator=(const ProbeFolder&) = delete;
  ~ProbeFolder();
  const std::filesystem::path& path() const { return path_; }
  /// The path of a file that holds these bytes.
  std::string write(const char* name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

/// The one of this process; removed at its end.
const ProbeFolder& probe_folder();

}  // namespace cagetol
