#include "mc/study_file/file_seal.hpp"

#include <fmt/format.h>

#include "mc/study_file/checksum.hpp"

namespace cagetol {
namespace {

constexpr std::string_view kTitle = "cagetol sealed HDF5, version ";
constexpr std::string_view kVersion = "1\n";
constexpr std::string_view kHdf5 = "\x89HDF\r\n\x1a\n";

std::string seal_of(std::string_view content) {
  std::string seal = fmt::format("{}{}bytes {}\ncrc64 {:016x}\n", kTitle, kVersion,
                                 content.size() + kSealSize, crc64(content));
  seal.resize(kSealSize, '\0');
  return seal;
}

std::string problem_of(std::string_view file, std::string_view expected) {
  const std::string_view seal = file.substr(0, kSealSize);
  if (file.empty()) return "it is empty";
  if (file.starts_with(kHdf5))
    return "it has no checksum: another program wrote it, or a cagetol of schema 1";
  if (!seal.starts_with(kTitle)) {
    if (kTitle.starts_with(seal.substr(0, kTitle.size())))
      return fmt::format("it is cut short: {} bytes are left", file.size());
    return file.substr(seal.size()).starts_with(kHdf5)
               ? "the block with its checksum is damaged"
               : "it is neither an HDF5 file nor one of this program (damaged, or another file)";
  }
  const std::string_view version = seal.substr(kTitle.size());
  if (!version.starts_with(kVersion))
    return fmt::format("the version of its seal is {}, this program knows 1 (damaged, or newer)",
                       version.substr(0, 1));
  if (file.size() < kSealSize)
    return fmt::format("it is cut short: {} bytes are left", file.size());
  const auto length_line = [](std::string_view block) {
    return block.substr(kTitle.size() + kVersion.size(), block.find("crc64") - kTitle.size());
  };
  if (length_line(seal) != length_line(expected))
    return fmt::format("it has {} bytes, and its seal says another number: cut short or damaged",
                       file.size());
  return "its checksum does not match: some of its bytes have changed since it was written";
}

}  // namespace

std::string sealed(std::string file) {
  const std::string seal = seal_of(std::string_view(file).substr(kSealSize));
  return file.replace(0, kSealSize, seal);
}

std::string seal_problem(std::string_view file) {
  const std::string expected =
      seal_of(file.size() < kSealSize ? std::string_view() : file.substr(kSealSize));
  return file.substr(0, kSealSize) == expected ? "" : problem_of(file, expected);
}

}  // namespace cagetol
