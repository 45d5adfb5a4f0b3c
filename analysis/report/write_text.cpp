#include "analysis/report/write_text.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "mc/study_file/study_file_error.hpp"

namespace cagetol {

void write_text(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path temporary = file.string() + ".tmp";
  errno = 0;
  std::ofstream stream(temporary, std::ios::binary);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(temporary, file, error);
  if (stream && !error) return;
  const std::string reason = error ? error.message() : std::strerror(errno != 0 ? errno : EIO);
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw StudyFileError(
      file.string(), "cannot be written: " + reason,
      "check the directory's permissions and free space, then run `cagetol report DIR` again");
}

}  // namespace cagetol
