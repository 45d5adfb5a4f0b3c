#include "mc/host/private_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace cagetol {
namespace {

constexpr mode_t kOthersWrite = S_IWGRP | S_IWOTH;

/// Lest a damaged size takes all memory.
constexpr off_t kLargestFile = off_t{1} << 30;

std::filesystem::path parent_of(const std::filesystem::path& path) {
  const auto parent = path.parent_path();
  return parent.empty() ? "." : parent;
}

void make_folder(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(parent_of(path), error);
  if (error) throw WriteError(path.string(), "create the folder", error.value());
  if (::mkdir(path.c_str(), 0700) != 0 && errno != EEXIST)
    throw WriteError(path.string(), "create the folder", errno);
}

void refuse_foreign_link(const std::filesystem::path& path) {
  struct stat link, parent;
  if (::lstat(path.c_str(), &link) != 0 || !S_ISLNK(link.st_mode)) return;
  const bool shared =
      ::stat(parent_of(path).c_str(), &parent) != 0 || !foreign_hand(parent).empty();
  if (shared || (link.st_uid != ::geteuid() && link.st_uid != 0))
    throw NotPrivate(path.string() + " is a link that another user may have made");
}

/// Without a trailing slash, which would hide that the path is a link.
std::filesystem::path plain(const std::filesystem::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

/// Appends all bytes of a file. Returns 0 or the errno of the failure.
int read_all(int file, std::string& bytes) {
  char part[1 << 16];
  for (;;) {
    const ssize_t count = ::read(file, part, sizeof part);
    if (count == 0) return 0;
    if (count < 0 && errno != EINTR) return errno;
    if (count > 0) bytes.append(part, static_cast<std::size_t>(count));
  }
}

}  // namespace

std::string foreign_hand(const struct stat& status) {
  if (status.st_uid != ::geteuid() && status.st_uid != 0)
    return fmt::format("belongs to user {}", status.st_uid);
  if ((status.st_mode & kOthersWrite) != 0)
    return fmt::format("may be written by others than its owner (mode {:04o})",
                       status.st_mode & 07777);
  return "";
}

PrivateFolder::PrivateFolder(const std::filesystem::path& path) : path_(plain(path)) {
  make_folder(path_);
  refuse_foreign_link(path_);
  folder_ = FileDescriptor(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder_.get() < 0) throw WriteError(path_.string(), "open the folder", errno);
  struct stat status;
  if (::fstat(folder_.get(), &status) != 0)
    throw WriteError(path_.string(), "open the folder", errno);
  if (const std::string why = foreign_hand(status); !why.empty())
    throw NotPrivate(path_.string() + " " + why);
}

std::optional<std::string> PrivateFolder::read(const std::string& name) const {
  // A pipe of that name must not block.
  const FileDescriptor file(
      ::openat(folder_.get(), name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file.get() < 0 && errno == ENOENT) return std::nullopt;
  const auto refuse = [&](const std::string& why) {
    throw NotPrivate((path_ / name).string() + " " + why);
  };
  if (file.get() < 0 && errno == ELOOP) refuse("is a symbolic link");
  if (file.get() < 0) refuse(std::string("cannot be opened: ") + std::strerror(errno));
  struct stat status;
  if (::fstat(file.get(), &status) != 0 || !S_ISREG(status.st_mode)) refuse("is no regular file");
  if (const std::string why = foreign_hand(status); !why.empty()) refuse(why);
  if (status.st_size > kLargestFile) refuse("is larger than any file that is kept here");
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(status.st_size));
  if (const int error = read_all(file.get(), bytes))
    refuse(std::string("cannot be read: ") + std::strerror(error));
  return bytes;
}

void PrivateFolder::replace(const std::string& name, std::string_view bytes) const {
  remove_stale_parts(path_.string());
  replace_file((path_ / name).string(), bytes, 0600);
}

}  // namespace cagetol
