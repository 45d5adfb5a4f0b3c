// A checksum for files that are written once and read whole.
#pragma once

#include <cstdint>
#include <string_view>

namespace cagetol {

/// CRC-64/XZ: polynomial 0x42F0E1EBA9EA3693, reflected, starting from and finished with all ones;
/// "123456789" gives 0x995DC9BBDF1939FA. Finds every change within 64 neighbouring bits; any other
/// change escapes it with probability 2^-64.
std::uint64_t crc64(std::string_view bytes);

}  // namespace cagetol
