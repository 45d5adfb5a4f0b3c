// A folder whose files nobody else can have written. What is read from a cache is believed, so it
// must not come from another user: shared folders like /tmp let anybody make a folder, or a link,
// of the name that a program is known to use.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "mc/host/file_write.hpp"

namespace cagetol {

/// A folder or a file in it is not safe to use; the message names it and says why.
class NotPrivate : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Why a folder or file with this status is not safe to use, empty where it is: it belongs to
/// neither this user nor root, or others than its owner may write to it. "belongs to user 1003".
std::string foreign_hand(const struct stat& status);

class PrivateFolder {
 public:
  /// Opens the folder, made with mode 0700 where it is missing. A symbolic link is followed where
  /// it belongs to this user or root and lies in a folder to which others may not write. Throws
  /// NotPrivate, and WriteError where there is no folder and none can be made.
  explicit PrivateFolder(const std::filesystem::path& path);

  /// All bytes of a file; nothing where there is no such file. Throws NotPrivate for a file that
  /// another user may have written, that is a link or no regular file, or cannot be read.
  std::optional<std::string> read(const std::string& name) const;

  /// Replaces a file (replace_file), readable by this user alone, and clears away what writers that
  /// died have left. Throws WriteError.
  void replace(const std::string& name, std::string_view bytes) const;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  FileDescriptor folder_;
};

}  // namespace cagetol
