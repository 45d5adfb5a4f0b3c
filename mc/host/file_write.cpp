#include "mc/host/file_write.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>

namespace cagetol {
namespace {

constexpr const char* kPart = ".part";

std::string remedy(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free some space, then start the same command again: finished samples are kept";
    case EFBIG:
      return "raise the limit on file size (ulimit -f), then start the same command again: "
             "finished samples are kept";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a directory that you may write to with -o, or change its permissions";
    case EMFILE:
    case ENFILE:
      return "raise the limit on open files (ulimit -n)";
    case ENAMETOOLONG:
    case ENOTDIR:
    case EEXIST:
    case EISDIR:
      return "choose another output directory with -o";
    case ENOENT:
      return "give it its old name if it was renamed, then start the same command again; samples "
             "in files that are gone run anew";
    default:
      return "check the file system, then start the same command again: finished samples are kept";
  }
}

bool is_passing(int error_number) {
  return error_number == ENOSPC || error_number == EDQUOT || error_number == EFBIG ||
         error_number == EIO;
}

std::string problem_text(const std::string& file, const std::string& action, int error_number) {
  return file + ": cannot " + action + ": " + std::strerror(error_number);
}

/// The process that writes NAME.partPID; 0 where `name` is no such name.
pid_t writer_of(const std::string& name) {
  const std::size_t mark = name.rfind(kPart);
  if (mark == std::string::npos) return 0;
  const std::string digits = name.substr(mark + std::strlen(kPart));
  const bool is_number = !digits.empty() && digits.size() < 10 &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? static_cast<pid_t>(std::stol(digits)) : 0;
}

}  // namespace

WriteError::WriteError(const std::string& file, const std::string& action, int error_number)
    : std::runtime_error(problem_text(file, action, error_number) +
                         "\n  remedy: " + remedy(error_number)),
      problem_(problem_text(file, action, error_number)),
      can_go_on_(is_passing(error_number)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

int FileDescriptor::release() {
  return std::exchange(descriptor_, -1);
}

int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw WriteError(directory, "create the directory", error.value());
}

void sync_directory(const std::string& directory) {
  const FileDescriptor opened(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.get() < 0) throw WriteError(directory, "open", errno);
  // Some network file systems know no fsync of a directory (EINVAL): there the rename itself is all
  // one can have.
  if (::fsync(opened.get()) != 0 && errno != EINVAL) throw WriteError(directory, "sync", errno);
}

void replace_file(const std::string& path, std::string_view bytes, unsigned mode) {
  const std::string temporary = path + kPart + std::to_string(::getpid());
  int error_number = 0;
  {
    const FileDescriptor file(
        ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, mode));
    if (file.get() < 0) throw WriteError(path, "write", errno);
    error_number = write_all(file.get(), bytes);
    if (error_number == 0 && ::fsync(file.get()) != 0) error_number = errno;
  }
  if (error_number == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) error_number = errno;
  if (error_number != 0) {
    ::unlink(temporary.c_str());
    throw WriteError(path, "write", error_number);
  }
  const auto parent = std::filesystem::path(path).parent_path();
  sync_directory(parent.empty() ? "." : parent.string());
}

void remove_stale_parts(const std::string& directory, std::chrono::seconds age) {
  const auto limit = std::filesystem::file_time_type::clock::now() - age;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    const pid_t writer = writer_of(entry->path().filename().string());
    if (writer == 0) continue;
    std::error_code gone;
    const auto time = std::filesystem::last_write_time(entry->path(), gone);
    // Processes of another machine that shares the directory cannot be asked; they do not write
    // for so long.
    if (!gone && time <= limit && ::kill(writer, 0) != 0 && errno == ESRCH)
      ::unlink(entry->path().c_str());
  }
}

}  // namespace cagetol
