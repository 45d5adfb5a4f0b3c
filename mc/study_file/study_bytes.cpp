#include "mc/study_file/study_bytes.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>

#include "mc/study_file/file_seal.hpp"
#include "mc/study_file/study_file_error.hpp"

namespace cagetol {
namespace {

class OpenFile {
 public:
  explicit OpenFile(const std::string& name)
      : descriptor_(::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  int get() const { return descriptor_; }

 private:
  int descriptor_;
};

[[noreturn]] void cannot_open(const std::string& name, int error) {
  const auto stage = std::filesystem::path(name).parent_path() / "mixture";
  if (error == ENOENT && std::filesystem::exists(stage))
    throw StudyFileError(name, "there is no such file: this is a recommendation",
                         "name the directory of a stage, such as " + stage.string());
  if (error == ENOENT)
    throw StudyFileError(
        name, "there is no such file",
        "run `cagetol sweep STUDY -o DIR` first, or name the directory that holds study.h5");
  throw StudyFileError(name, std::string("cannot be read: ") + std::strerror(error),
                       error == EACCES || error == EPERM
                           ? "give yourself permission to read it (chmod u+r), and its directories"
                           : "name the directory of a sweep, and check the file system");
}

std::string all_of(const OpenFile& file, const std::string& name) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) cannot_open(name, errno);
  if (!S_ISREG(status.st_mode))
    throw StudyFileError(name, "is no file but a directory or a device",
                         "name the directory of a sweep, which holds study.h5");
  std::string bytes;
  try {
    bytes.resize(static_cast<std::size_t>(status.st_size));
  } catch (const std::bad_alloc&) {
    throw StudyFileError(
        name, "the memory does not suffice for its " + std::to_string(status.st_size >> 20) + " MB",
        "free some memory, or raise the limit on it (ulimit -v)");
  }
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t count = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannot_open(name, errno);
    if (count == 0) break;  // it became shorter meanwhile: its seal will tell
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

bool is_locked(const OpenFile& file) {
  if (::flock(file.get(), LOCK_SH | LOCK_NB) != 0) return errno == EWOULDBLOCK;
  ::flock(file.get(), LOCK_UN);
  return false;
}

}  // namespace

std::string read_study_bytes(const std::filesystem::path& path) {
  const std::string name = path.string();
  const OpenFile file(name);
  if (file.get() < 0) cannot_open(name, errno);
  std::string bytes = all_of(file, name);
  const std::string problem = seal_problem(bytes);
  if (problem.empty()) return bytes;
  if (is_locked(file))
    throw StudyFileError(name, "another program has locked it and may be changing it; " + problem,
                         "end that program, then try again");
  throw StudyFileError(name, problem, kRebuildRemedy);
}

}  // namespace cagetol
