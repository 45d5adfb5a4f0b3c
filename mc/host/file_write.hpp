// Writing files so that a reader sees all of it or nothing, and a full disk is told apart from a
// broken program.
#pragma once

#include <chrono>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cagetol {

/// Results could not be written. What was finished before is kept; the same command goes on once
/// the reason is removed.
class WriteError : public std::runtime_error {
 public:
  /// Message: "FILE: cannot ACTION: REASON\n  remedy: ..."; the remedy follows from `error_number`
  /// (an errno).
  WriteError(const std::string& file, const std::string& action, int error_number);
  /// "FILE: cannot ACTION: REASON", without the remedy.
  const std::string& problem() const { return problem_; }
  /// True when the place itself is fine and the same command can go on later: a full disk, a quota,
  /// a limit, a bad moment.
  bool can_go_on() const { return can_go_on_; }

 private:
  std::string problem_;
  bool can_go_on_;
};

/// A POSIX file descriptor, closed once.
class FileDescriptor {
 public:
  explicit FileDescriptor(int descriptor = -1) : descriptor_(descriptor) {}
  FileDescriptor(FileDescriptor&& other) noexcept : descriptor_(other.release()) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor();
  int get() const { return descriptor_; }
  int release();

 private:
  int descriptor_;
};

/// Writes all of `bytes`, through short writes and interruptions. Returns 0 or the errno of the
/// failure.
int write_all(int descriptor, std::string_view bytes);

/// Replaces `path` by a file with these bytes: temporary name in the same directory, fsync, rename,
/// fsync of the directory. `mode` is that of a new file, less the umask. Throws WriteError and
/// leaves the old file as it was.
void replace_file(const std::string& path, std::string_view bytes, unsigned mode = 0666);

/// Removes temporary files that replace_file() left in `directory` because its process died: `age`
/// old or older, their process gone from this machine. Processes of another machine that shares the
/// directory cannot be asked; they do not write for an hour. What cannot be removed stays.
void remove_stale_parts(const std::string& directory,
                        std::chrono::seconds age = std::chrono::hours(1));

/// Makes a directory and those above it, where they are missing. Throws WriteError.
void make_directory(const std::string& directory);

/// Makes a new name in `directory` survive a power cut. Throws WriteError.
void sync_directory(const std::string& directory);

}  // namespace cagetol
