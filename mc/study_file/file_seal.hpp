// The seal of an HDF5 file: 512 bytes in front of it, the user block that HDF5 leaves alone, with
// its length and checksum. HDF5 1.10 crashes on damaged files, so a seal is checked before HDF5
// sees a byte.
//
// Block: "cagetol sealed HDF5, version 1\nbytes LENGTH\ncrc64 CHECKSUM\n", padded with zeros.
// LENGTH counts the whole file, the block included, in decimal; CHECKSUM is crc64() of all bytes
// behind the block in 16 hex digits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cagetol {

inline constexpr std::size_t kSealSize = 512;

/// The file with its first kSealSize bytes replaced by the seal of those behind them.
std::string sealed(std::string file);

/// Why not every byte is as written; empty where each is.
std::string seal_problem(std::string_view file);

}  // namespace cagetol
