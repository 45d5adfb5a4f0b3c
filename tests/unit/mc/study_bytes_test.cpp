#include "mc/study_file/study_bytes.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mc/study_file/file_seal.hpp"
#include "mc/study_file/hdf5_reader.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/process.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class StudyBytesTest : public testing::Test {
 protected:
  std::string message_of(const std::string& path) {
    try {
      read_study_bytes(path);
    } catch (const StudyFileError& error) {
      return error.what();
    }
    return "no error";
  }
  /// A small sound file followed by `end`.
  std::string written(const std::string& end = "") {
    const H5Handle file = make_h5_memory_file();
    write_h5(file, "value", std::vector<double>{1.5}, {"N", "a number"});
    std::ofstream(path_, std::ios::binary) << sealed_h5_image(file) << end;
    return path_;
  }
  ScratchDirectory scratch_;
  std::string path_ = scratch_ / "study.h5";
};

TEST_F(StudyBytesTest, ASoundFileIsGivenBackAsItIs) {
  const std::string bytes = read_study_bytes(written());
  EXPECT_TRUE(bytes == file_bytes(path_));
  EXPECT_EQ(Hdf5Reader(read_study_bytes(path_), path_).reals("/value").values,
            std::vector<double>{1.5});
}

TEST_F(StudyBytesTest, WhatKeepsAFileFromBeingReadIsToldApart) {
  EXPECT_THAT(message_of(path_), AllOf(HasSubstr(path_), HasSubstr("no such file")));
  std::filesystem::create_directory(path_);
  EXPECT_THAT(message_of(path_), HasSubstr("is no file but a directory"));
  std::filesystem::remove(path_);
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  EXPECT_THAT(message_of(path_), HasSubstr("is no file but a directory or a device"));
  std::filesystem::remove(path_);
  const std::string sound = file_bytes(written());
  std::ofstream(path_, std::ios::binary) << sound.substr(kSealSize);
  EXPECT_THAT(message_of(path_), AllOf(HasSubstr("has no checksum"), HasSubstr("remedy")));
  EXPECT_THAT(message_of(written("x")),
              AllOf(HasSubstr("another number"), HasSubstr("remedy"), Not(HasSubstr("locked"))));
}

TEST_F(StudyBytesTest, AFileThatMayNotBeReadIsNotCalledDamaged) {
  ::chmod(written().c_str(), 0);
  const bool is_root = ::geteuid() == 0;
  ASSERT_EQ(is_root ? ::seteuid(65534) : 0, 0);
  const std::string message = message_of(path_);
  ASSERT_EQ(is_root ? ::seteuid(0) : 0, 0);
  EXPECT_THAT(message, AllOf(HasSubstr("Permission denied"), HasSubstr("chmod")));
}

TEST_F(StudyBytesTest, ALockIsNamedOnlyWhereTheFileIsNotSound) {
  const int descriptor = ::open(written().c_str(), O_RDWR);
  ASSERT_EQ(::flock(descriptor, LOCK_EX), 0);
  EXPECT_EQ(message_of(path_), "no error");
  written("half of something");
  EXPECT_THAT(message_of(path_),
              AllOf(HasSubstr("another program has locked it"), HasSubstr("end that program")));
  ::close(descriptor);
}

/// A dataset of 8 GB that was never written takes no room in the file.
TEST_F(StudyBytesTest, ADimensionThatTheFileCannotHoldIsRefused) {
  const H5Handle file = make_h5_memory_file();
  {
    const hsize_t count = 1u << 30;
    const H5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "make a space");
    const H5Handle dataset(
        H5Dcreate2(file, "vast", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose, "make a dataset");
  }
  const std::string sealed = sealed_h5_image(file);
  const auto refused = testing::Throws<StudyFileError>(testing::Property(
      &StudyFileError::reason, HasSubstr("vast: it announces more values than the file can hold")));
  const Hdf5Reader reader(sealed, path_);
  EXPECT_THAT([&] { reader.reals("vast"); }, refused);
  EXPECT_THAT([&] { reader.integers("vast"); }, refused);
  EXPECT_THAT([&] { reader.strings("vast"); }, refused);
}

TEST_F(StudyBytesTest, TextThatIsNotUtf8IsRefused) {
  const H5Handle file = make_h5_memory_file();
  write_h5(file, "good", std::vector<std::string>{"\u00b5m", ""}, {"-", "texts"});
  write_h5(file, "bad", std::vector<std::string>{"a", "\xff\xfe"}, {"-", "texts"});
  write_h5_attribute(file, "bad", "\xc3(");
  const std::string sealed = sealed_h5_image(file);
  const Hdf5Reader reader(sealed, path_);
  EXPECT_EQ(reader.strings("good").size(), 2u);
  EXPECT_THROW(reader.strings("bad"), StudyFileError);
  EXPECT_THROW(reader.text_attribute("/", "bad"), StudyFileError);
}

}  // namespace
}  // namespace cagetol
