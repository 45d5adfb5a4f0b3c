#include "mc/host/private_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "tests/support/process.hpp"

namespace cagetol {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

void write(const std::string& path, const std::string& text = "text") {
  std::ofstream(path) << text;
  fs::permissions(path, fs::perms(0600));
}

std::string refusal_of_folder(const std::string& path) {
  try {
    const PrivateFolder folder(path);
  } catch (const NotPrivate& problem) {
    return problem.what();
  }
  return "accepted";
}

std::string refusal_of_file(const PrivateFolder& folder, const std::string& name) {
  try {
    return folder.read(name) ? "accepted" : "absent";
  } catch (const NotPrivate& problem) {
    return problem.what();
  }
}

mode_t mode_of(const std::string& path) {
  struct stat status {};
  ::lstat(path.c_str(), &status);
  return status.st_mode & 07777;
}

TEST(PrivateFolder, IsMadeForItsUserAlone) {
  const ScratchDirectory scratch;
  const mode_t old = ::umask(0);
  const PrivateFolder folder(scratch / "a/b/");
  folder.replace("file", "bytes");
  ::umask(old);
  EXPECT_EQ(mode_of(scratch / "a/b"), 0700u);
  EXPECT_EQ(mode_of(scratch / "a/b/file"), 0600u);
  EXPECT_EQ(folder.read("file"), "bytes");
  EXPECT_EQ(folder.read("other"), std::nullopt);
}

TEST(PrivateFolder, ForeignOwnersAndWritersAreNamed) {
  struct stat status {};
  status.st_uid = ::geteuid();
  status.st_mode = 0755;
  EXPECT_EQ(foreign_hand(status), "");
  status.st_mode = 0775;
  EXPECT_EQ(foreign_hand(status), "may be written by others than its owner (mode 0775)");
  status.st_mode = 01757;
  EXPECT_EQ(foreign_hand(status), "may be written by others than its owner (mode 1757)");
  status.st_mode = 0700;
  status.st_uid = ::geteuid() + 1234;
  EXPECT_EQ(foreign_hand(status), "belongs to user " + std::to_string(status.st_uid));
  status.st_uid = 0;
  EXPECT_EQ(foreign_hand(status), "");
}

TEST(PrivateFolder, OneThatOthersMayWriteToIsRefused) {
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "open");
  fs::permissions(scratch / "open", fs::perms(0777));
  EXPECT_EQ(refusal_of_folder(scratch / "open"),
            scratch / "open" + " may be written by others than its owner (mode 0777)");
  fs::permissions(scratch / "open", fs::perms(0755));
  EXPECT_EQ(refusal_of_folder(scratch / "open"), "accepted");
}

TEST(PrivateFolder, OneOfAnotherUserIsRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "theirs");
  ASSERT_EQ(::chown((scratch / "theirs").c_str(), 54321, 54321), 0);
  EXPECT_EQ(refusal_of_folder(scratch / "theirs"), scratch / "theirs" + " belongs to user 54321");
  const PrivateFolder folder(scratch / "mine");
  write(scratch / "mine/file");
  ASSERT_EQ(::chown((scratch / "mine/file").c_str(), 54321, 54321), 0);
  EXPECT_EQ(refusal_of_file(folder, "file"), scratch / "mine/file" + " belongs to user 54321");
}

TEST(PrivateFolder, ALinkIsFollowedOnlyWhereNobodyElseCanHaveMadeIt) {
  const ScratchDirectory scratch;
  fs::create_directory(scratch / "target");
  fs::permissions(scratch / "target", fs::perms(0700));
  for (const auto& [mode, verdict] : {std::pair{0700, "accepted"}, {01777, "link"}}) {
    const std::string parent = scratch / std::to_string(mode);
    fs::create_directory(parent);
    fs::create_symlink(scratch / "target", parent + "/cache");
    fs::permissions(parent, fs::perms(mode));
    EXPECT_THAT(refusal_of_folder(parent + "/cache"), HasSubstr(verdict));
    EXPECT_THAT(refusal_of_folder(parent + "/cache/"), HasSubstr(verdict));
  }
}

TEST(PrivateFolder, WhatIsNoFolderIsAWriteError) {
  const ScratchDirectory scratch;
  write(scratch / "file");
  EXPECT_THROW(PrivateFolder(scratch / "file"), WriteError);
  EXPECT_THROW(PrivateFolder(scratch / "file/below"), WriteError);
}

TEST(PrivateFolder, FilesThatAnotherMayHaveWrittenAreRefused) {
  const ScratchDirectory scratch;
  const PrivateFolder folder(scratch / "mine");
  write(scratch / "mine/file");
  EXPECT_EQ(refusal_of_file(folder, "file"), "accepted");
  fs::permissions(scratch / "mine/file", fs::perms(0620));
  EXPECT_THAT(refusal_of_file(folder, "file"), HasSubstr("may be written by others"));
  fs::create_symlink(scratch / "mine/file", scratch / "mine/link");
  EXPECT_EQ(refusal_of_file(folder, "link"), scratch / "mine/link" + " is a symbolic link");
  fs::create_directory(scratch / "mine/folder");
  EXPECT_EQ(refusal_of_file(folder, "folder"), scratch / "mine/folder" + " is no regular file");
  ASSERT_EQ(::mkfifo((scratch / "mine/pipe").c_str(), 0600), 0);
  EXPECT_EQ(refusal_of_file(folder, "pipe"), scratch / "mine/pipe" + " is no regular file");
  write(scratch / "mine/huge");
  fs::resize_file(scratch / "mine/huge", std::uintmax_t{1} << 40);
  EXPECT_THAT(refusal_of_file(folder, "huge"), HasSubstr("larger than any file"));
}

/// The number of a process that has ended.
pid_t ended_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(StaleParts, OnlyOldOnesOfDeadProcessesAreRemoved) {
  const ScratchDirectory scratch;
  const auto name = [](const std::string& file, pid_t writer) {
    return file + ".part" + std::to_string(writer);
  };
  const pid_t dead = ended_process();
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(2);
  const std::string stale = name("a.bin", dead), alive = name("a.bin", ::getpid()),
                    fresh = name("b.bin", dead), other = "a.bin.partial", unnumbered = "a.bin.part",
                    table = "a.bin";
  for (const std::string& file : {stale, alive, fresh, other, unnumbered, table}) {
    write(scratch / file);
    if (file != fresh) fs::last_write_time(scratch / file, old);
  }
  remove_stale_parts(scratch.path());
  EXPECT_FALSE(fs::exists(scratch / stale));
  for (const std::string& file : {alive, fresh, other, unnumbered, table})
    EXPECT_TRUE(fs::exists(scratch / file)) << file;
  remove_stale_parts(scratch / "absent");
}

TEST(StaleParts, WritingATableClearsThem) {
  const ScratchDirectory scratch;
  const PrivateFolder folder(scratch.path());
  const std::string stale = scratch / ("x.part" + std::to_string(ended_process()));
  write(stale);
  fs::last_write_time(stale, fs::file_time_type::clock::now() - std::chrono::hours(2));
  folder.replace("y", "bytes");
  EXPECT_FALSE(fs::exists(stale));
}

}  // namespace
}  // namespace cagetol
