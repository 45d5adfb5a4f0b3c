#include "mc/study_file/file_seal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mc/study_file/checksum.hpp"
#include "mc/study_file/h5.hpp"

namespace cagetol {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A small HDF5 file as it is written.
std::string small_file() {
  const H5Handle file = make_h5_memory_file();
  write_h5(file, "value", std::vector<double>{1.5, -2}, {"N", "two numbers"});
  write_h5(file, "name", std::vector<std::string>{"a", "µm", ""}, {"-", "three texts"});
  return sealed_h5_image(file);
}

TEST(ChecksumTest, GivesTheCatalogueValueOfCrc64Xz) {
  EXPECT_EQ(crc64("123456789"), 0x995DC9BBDF1939FAu);
  EXPECT_EQ(crc64(""), 0u);
}

TEST(FileSealTest, TheBlockIsTextWithLengthAndChecksum) {
  const std::string file = small_file();
  EXPECT_THAT(file, StartsWith("cagetol sealed HDF5, version 1\nbytes " +
                               std::to_string(file.size()) + "\ncrc64 "));
  EXPECT_THAT(file.substr(kSealSize), StartsWith("\x89HDF\r\n\x1a\n"));
  EXPECT_EQ(seal_problem(file), "");
}

TEST(FileSealTest, EverySingleBitIsGuarded) {
  std::string file = small_file();
  for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
    const auto flip = [&] { file[bit / 8] = static_cast<char>(file[bit / 8] ^ (1 << bit % 8)); };
    flip();
    ASSERT_FALSE(seal_problem(file).empty()) << bit;
    flip();
  }
}

TEST(FileSealTest, ACutOrGrownFileIsNamedAsSuch) {
  const std::string file = small_file();
  EXPECT_EQ(seal_problem(""), "it is empty");
  for (const std::size_t size : {std::size_t{1}, std::size_t{100}, kSealSize, file.size() - 1})
    EXPECT_THAT(seal_problem(file.substr(0, size)), HasSubstr("cut short")) << size;
  EXPECT_THAT(seal_problem(file + "x"), HasSubstr(std::to_string(file.size() + 1)));
}

TEST(FileSealTest, SaysWhatIsWrong) {
  std::string file = small_file();
  file[file.size() - 1] ^= 1;
  EXPECT_THAT(seal_problem(file), HasSubstr("checksum does not match"));
  file = small_file();
  file[0] = 'X';
  EXPECT_THAT(seal_problem(file), HasSubstr("block with its checksum is damaged"));
  file = small_file();
  file[std::string("cagetol sealed HDF5, version ").size()] = '2';
  EXPECT_THAT(seal_problem(file), HasSubstr("version of its seal is 2"));
  EXPECT_THAT(seal_problem("a text of another program"), HasSubstr("neither an HDF5 file"));
}

TEST(FileSealTest, AnHdf5FileWithoutBlockIsRefused) {
  EXPECT_THAT(seal_problem(small_file().substr(kSealSize)), HasSubstr("has no checksum"));
}

}  // namespace
}  // namespace cagetol
