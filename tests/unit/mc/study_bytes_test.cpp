// schema1_study.h5: six quasi-static samples of inputs/studies/nu205.toml, written by commit
// 40abf54 with strings of variable length and no seal.
#include "mc/study_file/study_bytes.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "analysis/study/study_data.hpp"
#include "mc/study_file/file_seal.hpp"
#include "mc/study_file/hdf5_reader.hpp"
#include "mc/study_file/study_file_error.hpp"
#include "mc/study_file/unsealed_file.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/process.hpp"
#include "tests/support/sanitizers.hpp"

namespace cagetol {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kSchema1 = CAGETOL_SOURCE_DIR "/tests/unit/analysis/schema1_study.h5";

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

TEST_F(StudyBytesTest, AFileOfSchema1GivesTheSameStudy) {
  const StudyData study = read_study_data(kSchema1);
  EXPECT_EQ(study.provenance.schema_version, 1);
  EXPECT_EQ(study.provenance.study_name, "nu205");
  EXPECT_EQ(study.size(), 6u);
  EXPECT_EQ(study.pockets, 13u);
  EXPECT_EQ(study.inputs.size(), 7u);
  EXPECT_EQ(study.plan.limits.size(), 3u);
  const Column& displacement = *find_quantity(study, "ring_displacement_mean_um");
  EXPECT_EQ(displacement.unit, "um");
  EXPECT_GT(displacement.values.at(5), 1);
  EXPECT_EQ(check_seal(read_study_bytes(kSchema1)).state, SealState::whole);
}

TEST_F(StudyBytesTest, DamageToAFileWithoutSealEndsInAMessageOrAStudy) {
  const std::string whole = file_bytes(kSchema1);
  std::mt19937_64 random(37);
  int refused = 0;
  for (int round = 0; round < 25; ++round) {
    const std::size_t bit = random() % (8 * whole.size());
    std::ofstream(path_, std::ios::binary) << with_flipped_bit(whole, bit);
    try {
      read_study_data(path_);
    } catch (const StudyFileError& error) {
      ++refused;
      EXPECT_THAT(error.what(), AllOf(HasSubstr(path_), HasSubstr("remedy"))) << bit;
    }
  }
  EXPECT_GT(refused, 0);
}

/// A program that reads such a file itself ends with SIGSEGV.
TEST_F(StudyBytesTest, ACrashOfHdf5IsAMessage) {
  if (kSanitized) GTEST_SKIP() << "a sanitizer catches the crash";
  std::ofstream(path_, std::ios::binary) << with_flipped_bit(file_bytes(kSchema1), 717937);
  EXPECT_THAT(message_of(path_), HasSubstr("HDF5 crashed on it"));
}

TEST_F(StudyBytesTest, TheProcessThatReadsHasLimits) {
  if (kSanitized) GTEST_SKIP() << kNotItsOwnCost;
  const auto message = [&](const std::string& bytes, const UnsealedLimits& limits) {
    try {
      read_unsealed(bytes, "study.h5", limits);
    } catch (const StudyFileError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string bytes = file_bytes(kSchema1);
  EXPECT_EQ(message(bytes, {}), "no error");
  EXPECT_THAT(message(bytes, {.seconds = -1}), HasSubstr("HDF5 did not end within"));
  // Zeros that are packed well: 64 MB of them in a file of 70 KB.
  const H5Handle file = make_h5_memory_file();
  {
    const hsize_t count = 8 << 20, chunk = 1 << 20;
    const H5Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose, "make a space");
    const H5Handle packed(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
    H5Pset_chunk(packed, 1, &chunk);
    H5Pset_deflate(packed, 9);
    const H5Handle dataset(
        H5Dcreate2(file, "zeros", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, packed, H5P_DEFAULT),
        H5Dclose, "make a dataset");
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
             std::vector<double>(count).data());
  }
  const std::string zeros = sealed_h5_image(file).substr(kSealSize);
  EXPECT_EQ(message(zeros, {}), "no error");
  EXPECT_THAT(message(zeros, {.memory = 32 << 20}),
              HasSubstr("HDF5 wants far more memory for it than it can hold"));
}

/// A dataset of 8 GB that was never written takes no room in the file, sealed or not.
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
  std::ofstream(path_, std::ios::binary) << sealed.substr(kSealSize);
  EXPECT_THAT(message_of(path_), HasSubstr("announces more values than the file can hold"));
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
