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
  const int problem = error ? error.value() : errno != 0 ? errno : EIO;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  const std::string reason = std::string("cannot be written: ") + std::strerror(problem);
  constexpr const char* kAgain = "then run `cagetol report DIR` again";
  if (problem == ENOSPC || problem == EDQUOT || problem == EFBIG || problem == EIO)
    throw UnfinishedWrite(file.string(), reason, std::string("free some space, ") + kAgain);
  throw StudyFileError(file.string(), reason,
                       std::string("check the directory's permissions, ") + kAgain);
}

}  // namespace cagetol
